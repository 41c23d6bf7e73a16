#include "golden/plain_path.h"

#include <cstdint>

#include "render/pixel_hash.h"

namespace proofreel {

std::string plain_path(const std::string& name) {
  std::string path;
  for (const char c : name) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    path += plain || c == '_' || c == '-' || (c == '/' && !path.empty() && path.back() != '/') ? c : '_';
  }
  if (path == name && !path.empty() && path.back() != '/') return path;
  const std::string hash = bytes_hash({reinterpret_cast<const std::uint8_t*>(name.data()), name.size()});
  return path.append("-").append(hash.substr(0, 8));
}

}  // namespace proofreel
