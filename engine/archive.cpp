#include "engine/archive.h"

#include "engine/state_hash.h"

namespace proofreel {

std::vector<std::byte> sealed(const Mark& mark, std::uint32_t version, std::span<const std::byte> bytes) {
  ArchiveWriter head;
  head(mark, version, hash_of(bytes.data(), bytes.size()));
  std::vector<std::byte> all = head.bytes();
  all.insert(all.end(), bytes.begin(), bytes.end());
  return all;
}

std::variant<std::span<const std::byte>, std::string> unsealed(const Mark& mark, std::uint32_t version,
                                                               std::span<const std::byte> bytes) {
  constexpr std::size_t head_size = sizeof(Mark) + sizeof(std::uint32_t) + sizeof(std::uint64_t);
  const std::span<const std::byte> head = bytes.first(std::min(head_size, bytes.size()));
  ArchiveReader reader(head);
  Mark found_mark{};
  std::uint32_t found_version = 0;
  std::uint64_t hash = 0;
  reader(found_mark, found_version, hash);
  if (bytes.size() < sizeof(Mark) || found_mark != mark) return "was not written by this program";
  if (found_version > version && !reader.spoilt()) return "was written by a newer version of this program";
  if (found_version < version && !reader.spoilt()) return "was written by an older version of this program";
  const std::span<const std::byte> content = bytes.subspan(head.size());
  if (reader.spoilt() || hash != hash_of(content.data(), content.size())) return "is damaged or incomplete";
  return content;
}

}  // namespace proofreel
