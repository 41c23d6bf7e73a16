#include "scenarios/demonstrations/reading.h"

#include <algorithm>
#include <cmath>

namespace proofreel {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

/// What a text says, by words between spaces.
struct Words {
  int known = 0;
  int new_figures = 0;  ///< and names of one letter
  int new_words = 0;
};

/// Counts, and learns, what it has not seen before.
Words read(const std::string& text, std::set<std::string>& known) {
  Words words;
  for (std::size_t from = 0, to = 0; from < text.size(); from = to + 1) {
    to = std::min(text.find(' ', from), text.size());
    const std::string word = text.substr(from, to - from);
    const bool has_digit = std::any_of(word.begin(), word.end(), is_digit);
    const auto letters = std::count_if(word.begin(), word.end(), is_letter);
    if (!has_digit && letters == 0) continue;
    if (!known.insert(word).second) {
      ++words.known;
    } else {
      ++(has_digit || letters == 1 ? words.new_figures : words.new_words);
    }
  }
  return words;
}

constexpr double to_read = 0.3, to_recognise = 0.2;

double seconds_for(const Words& words) {
  return to_read * (words.new_words + words.new_figures) + to_recognise * words.known;
}

/// One past the last of the steps from `first` on that say the same.
std::size_t end_of_caption(const Story& story, std::size_t first) {
  const Step& step = story.steps[first];
  std::size_t end = first + 1;
  while (end < story.steps.size() && story.steps[end].caption == step.caption &&
         story.steps[end].heading == step.heading)
    ++end;
  return end;
}

}  // namespace

double seconds_to_read(const std::string& text, std::set<std::string>& known) {
  constexpr double to_find = 1, to_look = 0.5;
  const Words words = read(text, known);
  return words.new_words == 0 ? to_look + to_read * words.new_figures : to_find + seconds_for(words);
}

void give_time_to_read(Story& story, const std::vector<Story>& before, double stretch) {
  std::set<std::string> known;
  for (const Story& earlier : before) {
    for (const Step& step : earlier.steps) read(step.caption, known), read(step.heading, known);
  }
  std::string heading;
  for (std::size_t first = 0, end = 0; first < story.steps.size(); first = end) {
    end = end_of_caption(story, first);
    const Step& step = story.steps[first];
    double needed = seconds_to_read(step.caption, known);
    if (step.heading != heading) needed += seconds_for(read(step.heading, known));
    heading = step.heading;
    double shown = 0;
    for (std::size_t i = first; i < end; ++i) shown += story.steps[i].seconds;
    const double wanted = 0.25 * std::ceil(4 * needed);  // whole frames, at the usual rates
    story.steps[end - 1].seconds += std::max(0.0, stretch * wanted - shown);
  }
}

}  // namespace proofreel
