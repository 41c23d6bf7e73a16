#include "render/subtitles.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <sstream>

#include "render/draw_layers.h"
#include "scenarios/film.h"
#include "scenarios/formula.h"
#include "scenarios/runner.h"

namespace proofreel {
namespace {

constexpr std::int64_t seconds_of_a_name = 3;

/// Its lines; an empty one would end the cue.
void add_lines(const std::string& caption, std::vector<std::string>& lines) {
  std::istringstream text(plain_text(caption));
  for (std::string line; std::getline(text, line);) {
    if (line.find_first_not_of(" \t\r") != std::string::npos) lines.push_back(line);
  }
}

std::vector<std::string> lines_at(const Scenario& scenario, std::int64_t tick) {
  std::vector<std::string> lines;
  if (!scenario.stories.empty())
    add_lines(step_at(scenario.stories, static_cast<double>(tick) / scenario.scene.rate).caption, lines);
  const std::vector<CaptionView> captions = captions_at(scenario, tick);
  for (const bool top : {true, false}) {
    for (const CaptionView& caption : captions) {
      if (is_at_top(caption.at) == top) add_lines(caption.text, lines);
    }
  }
  return lines;
}

/// The section that begins at this frame; one that has begun before begins with the film.
const FilmSection* section_from(const std::vector<FilmSection>& sections, std::int64_t frame, bool film_begins) {
  const auto begins = [&](const FilmSection& section) {
    return section.first == frame || (film_begins && section.first < frame && frame <= section.last);
  };
  const auto found = std::find_if(sections.begin(), sections.end(), begins);
  return found == sections.end() ? nullptr : &*found;
}

/// Puts cues together, picture by picture.
class CueList {
 public:
  explicit CueList(int fps) : fps_(fps) {}

  void add(std::int64_t picture, std::vector<std::string> captions, const FilmSection* begins) {
    if (begins != nullptr || captions != captions_ || cues_.empty()) {
      Cue cue{picture, picture, captions};
      if (begins != nullptr) cue.lines.insert(cue.lines.begin(), begins->name);
      captions_ = std::move(captions);
      cues_.push_back(std::move(cue));
    }
    const bool name_alone = captions_.empty() && !cues_.back().lines.empty();
    if (!name_alone || picture < cues_.back().first + seconds_of_a_name * fps_) cues_.back().last = picture;
  }

  std::vector<Cue> take() {
    std::erase_if(cues_, [](const Cue& cue) { return cue.lines.empty(); });
    return std::move(cues_);
  }

 private:
  int fps_;
  std::vector<Cue> cues_;
  std::vector<std::string> captions_;  ///< of the last picture
};

/// "00:01:02,350"
std::string time_text(std::int64_t picture, int fps) {
  const std::int64_t ms = (picture * 1000 + fps / 2) / fps;
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%02lld:%02lld:%02lld,%03lld", static_cast<long long>(ms / 3600000),
                static_cast<long long>(ms / 60000 % 60), static_cast<long long>(ms / 1000 % 60),
                static_cast<long long>(ms % 1000));
  return text.data();
}

}  // namespace

std::vector<Cue> subtitles_of(Scenario& scenario, const FilmRequest& request, const std::vector<FilmSection>& sections,
                              const Progress& progress) {
  Runner runner(scenario);
  CueList cues(scenario.picture.fps);
  const auto total = static_cast<std::int64_t>(request.frames.size());
  std::int64_t done = 0;
  for (const std::int64_t frame : request.frames) {
    const std::int64_t tick = request.timeline[static_cast<std::size_t>(frame)];
    while (runner.tick() < tick) runner.step();
    const FilmSection* begins = section_from(sections, frame, done == 0);
    cues.add(request.card_pictures + done++, lines_at(scenario, tick), begins);
    if (progress) progress(done, total);
  }
  return cues.take();
}

std::string srt_text(const std::vector<Cue>& cues, int fps) {
  std::string text;
  std::size_t number = 0;
  for (const Cue& cue : cues) {
    text += std::to_string(++number) + "\n";
    text += time_text(cue.first, fps) + " --> " + time_text(cue.last + 1, fps) + "\n";
    for (const std::string& line : cue.lines) text += line + "\n";
    text += "\n";
  }
  return text;
}

}  // namespace proofreel
