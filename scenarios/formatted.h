#pragma once

/// Numbers in sentences.

#include <string>

namespace proofreel {

/// The number as printf writes it by `format`, which holds one conversion of a double: "%.3g", "%.1f ms".
std::string formatted(const char* format, double value);

}  // namespace proofreel
