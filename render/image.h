#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace proofreel {

/// Pixels of a picture, from its top left corner.
struct PixelRect {
  int x_px = 0;
  int y_px = 0;
  int width_px = 0;
  int height_px = 0;
  friend bool operator==(const PixelRect&, const PixelRect&) = default;
};

/// Pictures that are drawn one upon another in one place differ in few parts; who knows the one before need look at
/// no more. So each is told by the series it belongs to and by its number in it.
struct Edition {
  std::uint64_t series = 0;             ///< the program has no other with this number
  std::uint64_t number = 0;             ///< counted from 1; 0: of nothing that is known
  std::vector<PixelRect> changes = {};  ///< where it may differ from the number before

  bool same_as(const Edition& other) const { return number != 0 && series == other.series && number == other.number; }
  bool follows(const Edition& other) const {
    return other.number != 0 && series == other.series && number == other.number + 1;
  }
};

/// The bytes of a picture. Unlike a vector's they are not cleared, since almost everybody writes a picture whole before
/// reading it: clearing a large one would take a tenth of the time of decoding it. They know which edition of a picture
/// they are until somebody may have written to them.
class PixelBytes {
 public:
  PixelBytes() = default;
  explicit PixelBytes(std::size_t size) : data_(new std::uint8_t[size]), size_(size) {}
  PixelBytes(const PixelBytes& other) : PixelBytes(other.size_) {
    std::copy(other.begin(), other.end(), begin());
    edition_ = other.edition_;
  }
  PixelBytes(PixelBytes&& other) noexcept
      : data_(std::move(other.data_)),
        size_(std::exchange(other.size_, 0)),
        edition_(std::exchange(other.edition_, {})) {}
  PixelBytes& operator=(PixelBytes other) noexcept {
    data_.swap(other.data_);
    std::swap(size_, other.size_);
    std::swap(edition_, other.edition_);
    return *this;
  }

  const Edition& edition() const { return edition_; }
  void become(Edition edition) { edition_ = std::move(edition); }

  /// When the size changes, what was there is lost.
  void resize(std::size_t size) {
    if (size != size_) *this = PixelBytes(size);
  }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  std::uint8_t* data() {
    if (edition_.number != 0) edition_ = {};
    return data_.get();
  }
  const std::uint8_t* data() const { return data_.get(); }
  std::uint8_t* begin() { return data(); }
  std::uint8_t* end() { return data() + size_; }
  const std::uint8_t* begin() const { return data(); }
  const std::uint8_t* end() const { return data() + size_; }
  std::uint8_t& operator[](std::size_t i) { return data()[i]; }
  const std::uint8_t& operator[](std::size_t i) const { return data_[i]; }
  friend bool operator==(const PixelBytes& a, const PixelBytes& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
  }

 private:
  std::unique_ptr<std::uint8_t[]> data_;
  std::size_t size_ = 0;
  Edition edition_;
};

/// A picture: RGBA8, rows from the top, no padding. One buffer is drawn into, compared and encoded.
struct Image {
  int width_px = 0;
  int height_px = 0;
  PixelBytes rgba;

  Image() = default;
  /// All bytes 0.
  Image(int width, int height) : Image(uncleared(width, height)) {
    std::fill(rgba.begin(), rgba.end(), std::uint8_t{0});
  }
  /// To be written whole.
  static Image uncleared(int width, int height) {
    Image image;
    image.width_px = width;
    image.height_px = height;
    image.rgba.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
    return image;
  }

  std::size_t row_bytes() const { return static_cast<std::size_t>(width_px) * 4; }
  const std::uint8_t* row(int y) const { return rgba.data() + static_cast<std::size_t>(y) * row_bytes(); }
  std::uint8_t* row(int y) { return rgba.data() + static_cast<std::size_t>(y) * row_bytes(); }
};

}  // namespace proofreel
