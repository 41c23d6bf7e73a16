#pragma once

/// A matcher for Catch2 2.x:
///
///     CHECK_THAT((Pixels{image.data(), 640, 480}), MatchesGolden("menu/start"));

#include <catch2/catch.hpp>
#include <string>

#include "proofreel/golden.h"

namespace proofreel {

class MatchesGolden : public Catch::MatcherBase<Pixels> {
 public:
  explicit MatchesGolden(std::string name, PictureTolerance tolerance = {}, Goldens& goldens = Goldens::of_process())
      : name_(std::move(name)), tolerance_(std::move(tolerance)), goldens_(goldens) {}

  bool match(const Pixels& pixels) const override {
    check_ = goldens_.check(name_, pixels, tolerance_);
    return check_.passed();
  }
  std::string describe() const override {
    return "matches golden \"" + name_ + "\"\n" + name_of(check_.verdict) + ": " + check_.message;
  }

 private:
  std::string name_;
  PictureTolerance tolerance_;
  Goldens& goldens_;
  mutable PictureCheck check_;
};

}  // namespace proofreel

template <>
struct Catch::StringMaker<proofreel::Pixels> {
  static std::string convert(const proofreel::Pixels& pixels) {
    return "picture of " + std::to_string(pixels.width_px) + " x " + std::to_string(pixels.height_px) + " pixels";
  }
};
