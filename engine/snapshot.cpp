#include "engine/snapshot.h"

#include <algorithm>

namespace proofreel {

const BodyView* find_body(const Snapshot& snapshot, BodyId id) {
  const auto found = std::lower_bound(snapshot.bodies.begin(), snapshot.bodies.end(), id,
                                      [](const BodyView& view, BodyId wanted) { return view.id < wanted; });
  return found != snapshot.bodies.end() && found->id == id ? &*found : nullptr;
}

}  // namespace proofreel
