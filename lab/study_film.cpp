#include "lab/study_film.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>

#include "lab/chart.h"
#include "lab/print_colors.h"
#include "lab/study_analysis.h"
#include "lab/study_charts.h"
#include "render/draw.h"
#include "scenarios/runner.h"

namespace proofreel {
namespace {

// Sizes in pixels.
constexpr int chart_height = 380;
constexpr int header_height = 46;
constexpr int gap = 8;
constexpr double chart_scale = 0.62;

/// Where the panes are: one row for up to three, two for more.
struct Grid {
  int columns = 1;
  int rows = 1;
  int width = 0;   ///< of a pane
  int height = 0;  ///< of a pane, without its header

  explicit Grid(std::size_t panes) {
    const int count = static_cast<int>(panes);
    rows = count > 3 ? 2 : 1;
    columns = (count + rows - 1) / rows;
    width = (study_film_size.width_px - gap * (columns + 1)) / columns;
    height = (study_film_size.height_px - chart_height - gap * (rows + 1)) / rows - header_height;
  }
  int left(std::size_t pane) const { return gap + static_cast<int>(pane) % columns * (width + gap); }
  int top(std::size_t pane) const { return gap + static_cast<int>(pane) / columns * (height + header_height + gap); }
};

/// A run that goes on as far as the film has come.
class Pane {
 public:
  Pane(const Study& study, const StudyRun& run, GlContext& context, const Grid& grid)
      : scenario_(load_scenario(study.file, run.set)), canvas_(context, grid.width, grid.height) {
    const StudiedMethod& method = study.methods[run.method];
    const Scene& scene = scenario_->scene;
    scenario_->picture.size = {grid.width, grid.height};
    scenario_->picture.plots.clear();  // too small to be read here
    scenario_->picture.captions.clear();
    runner_ = std::make_unique<Runner>(
        *scenario_, method.peer ? make_peer(*method.peer, scene, method.preset) : make_simulation(scene));
    const std::string step = step_name(study, run);
    title_ = method.name + (step.empty() ? "" : ", " + step);
  }

  const std::string& title() const { return title_; }

  /// A run that fails stays where it was.
  const Image& picture_at(double seconds, std::int64_t frame) {
    const auto due = static_cast<std::int64_t>(std::floor(seconds * scenario_->scene.rate + 1e-9));
    try {
      while (!runner_->finished() && runner_->tick() < due) runner_->step();
    } catch (const ScenarioError&) {
      return image_;
    }
    draw_frame(canvas_, runner_->frame(frame), {scenario_->picture.theme}, image_);
    return image_;
  }

 private:
  std::unique_ptr<Scenario> scenario_;
  std::unique_ptr<Runner> runner_;
  Canvas canvas_;
  Image image_;
  std::string title_;
};

void paste(const Image& part, Image& whole, int left, int top) {
  const std::size_t row = static_cast<std::size_t>(part.width_px) * 4;
  for (int y = 0; y < part.height_px; ++y) {
    const std::size_t to = (static_cast<std::size_t>(top + y) * static_cast<std::size_t>(whole.width_px) +
                            static_cast<std::size_t>(left)) *
                           4;
    std::memcpy(&whole.rgba[to], &part.rgba[static_cast<std::size_t>(y) * row], row);
  }
}

/// The whole chart of the errors, with axes that stay.
Chart whole_chart(const Study& study, const std::vector<std::size_t>& runs, const std::vector<Trace>& traces) {
  Chart chart = error_chart(study, runs, traces);
  chart.title.clear();
  chart.notes.clear();
  double least = INFINITY;
  double most = 0;
  for (const ChartCurve& curve : chart.curves) {
    for (const ChartPoint& point : curve.points) {
      if (!(point.at.y > 0) || !std::isfinite(point.at.y)) continue;
      least = std::min(least, point.at.y);
      most = std::max(most, point.at.y);
    }
  }
  chart.x.range = Vec2d{0, study.duration_s};
  if (most > 0) chart.y.range = Vec2d{std::max(least, 1e-16), most};
  return chart;
}

Chart chart_until(const Chart& whole, double seconds) {
  Chart chart = whole;
  for (ChartCurve& curve : chart.curves) {
    std::erase_if(curve.points, [&](const ChartPoint& point) { return point.at.x > seconds + 1e-9; });
  }
  return chart;
}

class StudyFilm {
 public:
  StudyFilm(const Study& study, const std::vector<std::size_t>& runs, const std::vector<Trace>& traces,
            std::optional<GlBackend> gl)
      : context_(make_context(gl)),
        canvas_(*context_, study_film_size.width_px, study_film_size.height_px),
        grid_(runs.size()),
        chart_(whole_chart(study, runs, traces)) {
    for (const std::size_t run : runs)
      panes_.push_back(std::make_unique<Pane>(study, study.runs[run], *context_, grid_));
  }

  const Image& frame_at(double seconds, std::int64_t frame) {
    canvas_.clear(paper);
    draw_chart(seconds);
    for (std::size_t i = 0; i < panes_.size(); ++i) draw_header(i);
    canvas_.finish(image_);
    for (std::size_t i = 0; i < panes_.size(); ++i) {
      paste(panes_[i]->picture_at(seconds, frame), image_, grid_.left(i), grid_.top(i) + header_height);
    }
    return image_;
  }

 private:
  void draw_header(std::size_t pane) {
    const double left = grid_.left(pane);
    const double top = grid_.top(pane);
    const Color color = look_of_curve(pane).color;
    canvas_.rectangle({left, top}, {left + 30, top + header_height - 8}, 6, {color, color, 0});
    canvas_.text(panes_[pane]->title(), {std::round(left + 44), std::round(top + 30)}, 28, Align::left, ink);
  }

  void draw_chart(double seconds) {
    const int width = static_cast<int>(study_film_size.width_px / chart_scale);
    const int height = static_cast<int>(chart_height / chart_scale);
    const double top = study_film_size.height_px - chart_height;
    draw_marks(canvas_, placed(laid_out(chart_until(chart_, seconds), canvas_, width, height), chart_scale, {0, top}));
  }

  std::unique_ptr<GlContext> context_;
  Canvas canvas_;
  Grid grid_;
  Chart chart_;
  std::vector<std::unique_ptr<Pane>> panes_;
  Image image_;
};

}  // namespace

void film_study(const Study& study, const std::vector<std::size_t>& runs, const std::vector<Trace>& traces,
                std::optional<GlBackend> gl, Sink& sink, const Progress& progress) {
  StudyFilm film(study, runs, traces, gl);
  const int fps = fps_of(study);
  const auto frames = std::max<std::int64_t>(1, std::llround(study.duration_s * fps));
  for (std::int64_t i = 0; i < frames; ++i) {
    sink.frame(film.frame_at(static_cast<double>(i) / fps, i));
    progress(i + 1, frames);
  }
  sink.finish();
}

int fps_of(const Study& study) { return load_scenario(study.file, study.set)->picture.fps; }

}  // namespace proofreel
