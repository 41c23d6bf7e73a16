#pragma once

/// The colours of figures on white paper, beside those of what they show.

#include "render/color.h"

namespace proofreel {

inline constexpr Color ink{0x1F, 0x2A, 0x36};    ///< words, axes
inline constexpr Color quiet{0x59, 0x64, 0x70};  ///< notes
inline constexpr Color edge{0xB9, 0xBF, 0xC6};   ///< frames
inline constexpr Color paper{0xFF, 0xFF, 0xFF};

}  // namespace proofreel
