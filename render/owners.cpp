#include "render/owners.h"

#include <map>

#include "render/draw_layers.h"

namespace proofreel {
namespace {

std::uint32_t number_in(const std::uint8_t* pixel) {
  return pixel[0] | static_cast<std::uint32_t>(pixel[1]) << 8U | static_cast<std::uint32_t>(pixel[2]) << 16U;
}

/// The owners that are seen, each once, in place of all that were drawn.
OwnerPicture seen_of(const std::vector<Owner>& marks, const Image& numbers) {
  OwnerPicture picture{numbers.width_px, numbers.height_px, {Owner{}}, {}};
  std::map<Owner, std::uint32_t> index_of_owner{{Owner{}, 0}};
  std::vector<std::optional<std::uint32_t>> index_of_mark(marks.size());
  picture.indices.reserve(numbers.rgba.size() / 4);
  for (std::size_t at = 0; at < numbers.rgba.size(); at += 4) {
    std::optional<std::uint32_t>& index = index_of_mark[number_in(&numbers.rgba[at])];
    if (!index) {
      const Owner& owner = marks[number_in(&numbers.rgba[at])];
      const auto next = static_cast<std::uint32_t>(picture.owners.size());
      const auto [place, is_new] = index_of_owner.try_emplace(owner, next);
      if (is_new) picture.owners.push_back(owner);
      index = place->second;
    }
    picture.indices.push_back(*index);
  }
  return picture;
}

}  // namespace

OwnerPicture draw_owners(Canvas& canvas, const Frame& frame, const Style& style) {
  std::vector<Owner> marks{Owner{}};
  Image numbers;
  canvas.clear_for_owners();
  draw_layers(canvas, frame, style, &marks);
  canvas.finish(numbers);
  return seen_of(marks, numbers);
}

Image image_of(const OwnerPicture& picture) {
  Image image = Image::uncleared(picture.width_px, picture.height_px);
  std::uint8_t* pixel = image.rgba.data();
  for (const std::uint32_t index : picture.indices) {
    for (unsigned i = 0; i < 3; ++i) *pixel++ = static_cast<std::uint8_t>(index >> (8 * i));
    *pixel++ = 255;
  }
  return image;
}

std::optional<OwnerPicture> owner_picture_from(const Image& image, const std::vector<Owner>& owners) {
  OwnerPicture picture{image.width_px, image.height_px, owners, {}};
  picture.indices.reserve(image.rgba.size() / 4);
  for (std::size_t at = 0; at < image.rgba.size(); at += 4) {
    const std::uint32_t index = number_in(&image.rgba[at]);
    if (index >= owners.size()) return std::nullopt;
    picture.indices.push_back(index);
  }
  return picture;
}

}  // namespace proofreel
