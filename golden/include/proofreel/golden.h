#pragma once

/// Golden pictures for any program that has pixels: every picture is held against the one that was accepted before, and
/// a page shows what differs. Needs nothing but this header and the library proofreel::golden.
///
///     proofreel::Goldens goldens({"tests/golden", "out/report"});
///     const proofreel::PictureCheck check = goldens.check("menu/start", {pixels, 640, 480});
///     if (!check.passed()) fail(check.message);
///
/// A picture without a reference fails. References are written when the environment says PROOFREEL_BLESS=1, and never
/// when it says CI=true: somebody has to look at them. What passes is not touched.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace proofreel {

/// A picture of yours, looked at where it is: red, green, blue, alpha, 8 bits each, rows from the top.
struct Pixels {
  const std::uint8_t* rgba = nullptr;
  int width_px = 0;
  int height_px = 0;
  std::size_t row_bytes = 0;  ///< from one row to the next; 0: 4 * width_px
};

/// What may differ without failing: every channel by `max_channel` of 255, and beyond that `pixels` pixels by anything.
struct PictureTolerance {
  int max_channel = 0;
  std::int64_t pixels = 0;
  std::string reason = {};  ///< must be given when either is not 0
};

enum class PictureVerdict : std::uint8_t {
  exact,      ///< the same pixels
  tolerated,  ///< others, within the tolerance
  drawing,    ///< other pixels
  missing,    ///< no reference, or none that can be read
  size,       ///< another size than the reference
  orphan,     ///< a reference nobody asked for
  blessed     ///< the reference was written just now
};
const char* name_of(PictureVerdict verdict);

struct PictureCheck {
  std::string name;
  PictureVerdict verdict = PictureVerdict::exact;
  std::string message;  ///< a sentence with figures, files and what to do; empty when exact
  bool passed() const {
    return verdict == PictureVerdict::exact || verdict == PictureVerdict::tolerated ||
           verdict == PictureVerdict::blessed;
  }
};

/// A folder of references, NAME.png each, and what was found in this run. For one thread at a time.
class Goldens {
 public:
  /// Remembers the folder; makes none. With a `report` folder, a page is written there at the end (index.html). Throws
  /// std::runtime_error when that folder holds anything else, and with PROOFREEL_BLESS=1 when CI=true.
  explicit Goldens(std::filesystem::path folder, std::filesystem::path report = {});
  /// Writes the report; what goes wrong with that is told on standard error.
  ~Goldens();
  Goldens(const Goldens&) = delete;
  Goldens& operator=(const Goldens&) = delete;

  /// The one of this process: references in PROOFREEL_GOLDEN, else in the nearest folder `golden` in or above the
  /// current one, else in ./golden; the report in PROOFREEL_REPORT, if that is set.
  static Goldens& of_process();

  /// Holds the picture against NAME.png. A name is a path without dots: "menu/start". Throws std::runtime_error when it
  /// is not, when the pixels are none or the tolerance has no reason, or when a file cannot be written.
  PictureCheck check(const std::string& name, const Pixels& pixels, const PictureTolerance& tolerance = {});

  /// The references that were not asked for, sorted: ask when all tests have run. They fail, in the report too.
  std::vector<PictureCheck> check_orphans();

  /// Writes the report now, and from then on no more by itself. Nothing without a report folder.
  void write_report();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace proofreel
