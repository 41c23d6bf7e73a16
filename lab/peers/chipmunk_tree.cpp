#include "lab/peers/chipmunk_tree.h"

#include <chipmunk/chipmunk.h>

namespace proofreel {
namespace {

struct Object {
  cpBB box;
  cpVect velocity;
};

cpBB box_of(void* object) { return static_cast<Object*>(object)->box; }
cpVect velocity_of(void* object) { return static_cast<Object*>(object)->velocity; }

cpCollisionID count(void*, void*, cpCollisionID id, void* counter) {
  ++*static_cast<std::size_t*>(counter);
  return id;
}

cpBB to_chipmunk(const BasicAabb<float>& box) {
  return cpBBNew(static_cast<cpFloat>(box.lower.x), static_cast<cpFloat>(box.lower.y),
                 static_cast<cpFloat>(box.upper.x), static_cast<cpFloat>(box.upper.y));
}

constexpr cpFloat cell = 1.5;       ///< m; Chipmunk advises about the size of a box
constexpr cpFloat lookahead = 0.1;  ///< s: the tree fattens a box by its velocity times this

}  // namespace

struct ChipmunkIndex::Impl {
  std::vector<Object> objects;
  cpSpatialIndex* index = nullptr;
};

ChipmunkIndex::ChipmunkIndex(Kind kind, const std::vector<BasicAabb<float>>& boxes) : impl_(std::make_unique<Impl>()) {
  for (const BasicAabb<float>& box : boxes) impl_->objects.push_back({to_chipmunk(box), cpvzero});
  if (kind == Kind::tree) {
    impl_->index = cpBBTreeNew(box_of, nullptr);
    cpBBTreeSetVelocityFunc(impl_->index, velocity_of);
  } else {
    impl_->index = cpSpaceHashNew(cell, static_cast<int>(10 * boxes.size()), box_of, nullptr);
  }
  cpHashValue id = 0;
  for (Object& object : impl_->objects) cpSpatialIndexInsert(impl_->index, &object, id++);
}

ChipmunkIndex::~ChipmunkIndex() { cpSpatialIndexFree(impl_->index); }

/// The velocities are scaled so that the tree looks as far ahead as the other sides do: four displacements.
std::size_t ChipmunkIndex::step(const std::vector<BasicAabb<float>>& boxes,
                                const std::vector<BasicVec2<float>>& displacements) {
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const BasicVec2<double> way(displacements[i]);
    impl_->objects[i] = {to_chipmunk(boxes[i]), cpv(4 / lookahead * way.x, 4 / lookahead * way.y)};
  }
  std::size_t pairs = 0;
  cpSpatialIndexReindexQuery(impl_->index, count, &pairs);
  return pairs;
}

}  // namespace proofreel
