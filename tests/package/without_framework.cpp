#include <proofreel/golden.h>

#include <exception>
#include <iostream>

#include "drawn.h"

int main() try {
  proofreel::Goldens& goldens = proofreel::Goldens::of_process();
  const std::vector<std::uint8_t> rgba = drawn();
  const proofreel::PictureCheck check = goldens.check("art/gradient", {rgba.data(), 96, 64});
  std::cout << proofreel::name_of(check.verdict) << " " << check.message << "\n";
  bool passed = check.passed();
  for (const proofreel::PictureCheck& orphan : goldens.check_orphans()) {
    std::cout << "orphan " << orphan.message << "\n";
    passed = false;
  }
  return passed ? 0 : 1;
} catch (const std::exception& error) {
  std::cout << error.what() << "\n";
  return 2;
}
