#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "render/image.h"

namespace proofreel {

/// XXH3-128 of a picture's size and bytes, as 32 hex digits: equal exactly when the pictures are.
std::string pixel_hash(const Image& image);

/// The same of any bytes.
std::string bytes_hash(std::span<const std::uint8_t> bytes);

}  // namespace proofreel
