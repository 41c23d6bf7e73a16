#pragma once

#include "render/draw.h"
#include "render/image.h"
#include "render/owner.h"

namespace proofreel {

/// Whose the pixels are that `draw_frame` draws of the same frame: all marks drawn once more, each in the number of
/// what it belongs to. Tells somebody who compares pictures which body, contact or text a pixel is a part of.
OwnerPicture draw_owners(Canvas& canvas, const Frame& frame, const Style& style);

/// The same as a picture that can be kept: each pixel the index of its owner, whose lowest byte is red.
Image image_of(const OwnerPicture& picture);
/// Nothing when a pixel names none of the owners.
std::optional<OwnerPicture> owner_picture_from(const Image& image, const std::vector<Owner>& owners);

}  // namespace proofreel
