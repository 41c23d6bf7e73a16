#include "render/framing.h"

#include <algorithm>
#include <cmath>

#include "render/draw_layers.h"

namespace proofreel {
namespace {

/// However many plots there are, the action keeps this part of the size that fits.
constexpr double smallest_action = 0.5;

/// The plots above or below the action; px.
struct Band {
  std::vector<std::size_t> plots;  ///< their places in the frame
  int columns = 1;
  double text = 0;  ///< what is left free of plots at the picture's edge, margin included
  double gap = 0;
  double plot_width = 0;
  double plot_height = 0;  ///< the least there can be, and then the one there is
  int rows() const { return (static_cast<int>(plots.size()) + columns - 1) / columns; }
  double plots_height() const { return rows() * (plot_height + gap); }
  double height() const { return plots.empty() ? 0 : text + plots_height(); }
};

class Layout {
 public:
  Layout(Canvas& canvas, const Frame& frame, const Sizes& sizes)
      : canvas_(canvas),
        frame_(frame),
        sizes_(sizes),
        size_{static_cast<double>(canvas.width_px()), static_cast<double>(canvas.height_px())},
        above_(band_of(true)),
        below_(band_of(false)) {}

  Framing framing() {
    const double whole = size_.x * frame_.view.made_for.height_px / frame_.view.made_for.width_px;
    while (free_of_plots() < whole && halve_rows()) {
    }
    const double action =
        std::clamp(whole, smallest_action * whole, std::max(smallest_action * whole, free_of_plots()));
    grow_plots(free_of_plots() - action);
    const double top = top_of_plots(action) + above_.plots_height();
    Framing framing{Camera(frame_.view, action / frame_.view.height, {0.5 * size_.x, top + 0.5 * action}), {}};
    framing.plots.resize(frame_.plots.size());
    put(above_, top - above_.plots_height(), framing.plots);
    put(below_, top + action + below_.gap, framing.plots);
    return framing;
  }

 private:
  /// Room at the top for the clock and a heading, at the bottom for two lines of caption.
  Band band_of(bool top) const {
    Band band;
    for (std::size_t i = 0; i < frame_.plots.size(); ++i) {
      if (is_at_top(frame_.plots[i].at) == top) band.plots.push_back(i);
    }
    band.gap = 0.25 * sizes_.margin;
    band.text = sizes_.margin + (top ? 1.3 * sizes_.small + 1.9 * sizes_.title : 3.2 * sizes_.text);
    measure(band);
    return band;
  }

  void measure(Band& band) const {
    band.plot_width = std::floor((size_.x - 2 * sizes_.margin - (band.columns - 1) * band.gap) / band.columns);
    band.plot_height = 0;
    for (const std::size_t i : band.plots) {
      const double height = least_plot_height(canvas_, sizes_, frame_.plots[i], band.plot_width);
      band.plot_height = std::max(band.plot_height, std::ceil(height));
    }
  }

  double free_of_plots() const { return size_.y - above_.height() - below_.height(); }

  /// False when there is nothing left to be put side by side.
  bool halve_rows() {
    Band& band = above_.rows() >= below_.rows() ? above_ : below_;
    if (band.rows() < 2 || band.columns == 2) return false;
    band.columns = 2;
    measure(band);
    return true;
  }

  /// Shares what room there is among all rows, up to twice as wide as high.
  void grow_plots(double room) {
    const double share = std::floor(std::max(0.0, room) / (above_.rows() + below_.rows()));
    for (Band* band : {&above_, &below_})
      band->plot_height = std::max(band->plot_height, std::min(band->plot_height + share, 0.5 * band->plot_width));
  }

  /// Plots and action together lie in the middle, as far as what is written leaves room.
  double top_of_plots(double action) const {
    const double block = above_.plots_height() + action + below_.plots_height();
    const double highest = above_.plots.empty() ? 0 : above_.text;
    const double lowest = size_.y - (below_.plots.empty() ? 0 : below_.text) - block;
    return std::floor(std::clamp(0.5 * (size_.y - block), highest, std::max(highest, lowest)));
  }

  void put(const Band& band, double top, std::vector<Aabbd>& places) const {
    for (std::size_t i = 0; i < band.plots.size(); ++i) {
      const auto columns = static_cast<std::size_t>(band.columns);
      const Vec2d low{std::floor(sizes_.margin + static_cast<double>(i % columns) * (band.plot_width + band.gap)),
                      std::floor(top + static_cast<double>(i / columns) * (band.plot_height + band.gap))};
      places[band.plots[i]] = {low, low + Vec2d{band.plot_width, std::floor(band.plot_height)}};
    }
  }

  Canvas& canvas_;
  const Frame& frame_;
  const Sizes& sizes_;
  Vec2d size_;
  Band above_;
  Band below_;
};

}  // namespace

Framing framing_of(Canvas& canvas, const Frame& frame, const Sizes& sizes) {
  const int width = canvas.width_px(), height = canvas.height_px();
  const bool has_bands = width <= height && is_too_narrow(frame.view, width, height);
  if (!frame.plots.empty() && has_bands) return Layout(canvas, frame, sizes).framing();
  return {Camera(frame.view, width, height), {}};
}

}  // namespace proofreel
