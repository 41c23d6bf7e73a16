#include "engine/scene_archive.h"

#include "engine/state_hash.h"

namespace proofreel {

std::uint64_t hash_of(const Scene& scene) {
  ArchiveWriter archive;
  archive(scene);
  return hash_of(archive.bytes().data(), archive.bytes().size());
}

}  // namespace proofreel
