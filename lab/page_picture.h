#pragma once

#include "render/image.h"

namespace proofreel {

/// A picture of a long page: headings, columns of text, and photographs. Always the same one; `changed`, one photograph
/// is another, and so is every eighth paragraph.
Image page_picture(int width_px, int height_px, bool changed);

}  // namespace proofreel
