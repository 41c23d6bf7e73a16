#pragma once

#include <string>

#include "render/image.h"

namespace proofreel {

/// What the difference of two pictures of one size looks like as a whole, as a sentence: the picture is moved by up to
/// 3 pixels, or tinted, or differs by the same everywhere. Empty when it looks like nothing known.
std::string likeness(const Image& expected, const Image& actual);

}  // namespace proofreel
