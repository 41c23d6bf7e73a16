#include "golden/frame_source.h"

#include <algorithm>
#include <filesystem>
#include <future>

#include "render/png.h"

namespace proofreel {
namespace {

namespace fs = std::filesystem;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Where the digits that begin at `from` end.
std::size_t end_of_number(const std::string& text, std::size_t from) {
  while (from < text.size() && is_digit(text[from])) ++from;
  return from;
}

/// The digits without zeros in front: the longer number is the larger one.
std::string number_at(const std::string& text, std::size_t from) {
  const std::size_t end = end_of_number(text, from);
  while (from + 1 < end && text[from] == '0') ++from;
  return text.substr(from, end - from);
}

std::vector<std::string> pictures_in(const std::string& folder) {
  std::vector<std::string> files;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().extension() == ".png") files.push_back(entry.path().string());
  }
  if (error) throw ImageError("Cannot read " + folder + ": " + error.message() + ".");
  if (files.empty()) throw ImageError("There are no .png files in " + folder + ".");
  std::sort(files.begin(), files.end(), comes_before);
  return files;
}

}  // namespace

ImagePair read_pair(const std::string& expected, const std::string& actual) {
  std::future<Image> other = std::async(std::launch::async, [&actual] { return read_png(actual); });
  Image first = read_png(expected);
  return {std::move(first), other.get()};
}

bool comes_before(const std::string& a, const std::string& b) {
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (is_digit(a[i]) && is_digit(b[j])) {
      const std::string m = number_at(a, i), n = number_at(b, j);
      if (m.size() != n.size()) return m.size() < n.size();
      if (m != n) return m < n;
      i = end_of_number(a, i), j = end_of_number(b, j);
    } else {
      if (a[i] != b[j]) return a[i] < b[j];
      ++i, ++j;
    }
  }
  if (i < a.size() || j < b.size()) return i == a.size();
  return a < b;  // 01 and 1: equal numbers, still two names
}

FrameSource::FrameSource(const std::string& path) {
  if (is_film_name(path)) {
    film_.emplace(path);
  } else {
    files_ = pictures_in(path);
  }
}

bool FrameSource::next(Image& image) {
  if (film_) return film_->next(image);
  if (next_file_ == files_.size()) return false;
  image = read_png(files_[next_file_++]);
  return true;
}

}  // namespace proofreel
