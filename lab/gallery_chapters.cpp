// Which scenario belongs to which chapter.

#include <algorithm>
#include <filesystem>
#include <set>

#include "golden/file_text.h"
#include "golden/json.h"
#include "lab/gallery.h"
#include "scenarios/suggest.h"

namespace proofreel {
namespace {

Json json_from(const std::string& path) {
  const std::optional<std::string> text = file_text(path);
  if (!text)
    throw ScenarioError("There is no file " + path +
                        ", which puts scenarios into chapters; with [] in it all are in one.");
  try {
    return Json::parse(*text);
  } catch (const Json::exception& error) {
    throw ScenarioError(path + ": " + problem_in_json(error, *text) + ": mend it, or put [] into the file, and all " +
                        "scenarios are in one chapter");
  }
}

[[noreturn]] void refuse_form(const std::string& path) {
  throw ScenarioError(path + ": must be a list of chapters, {\"title\", \"about\", \"scenarios\": [ids]} each");
}

std::vector<GalleryChapter> chapters_in(const std::string& path) {
  const Json json = json_from(path);
  std::vector<GalleryChapter> chapters;
  try {
    if (!json.is_array()) refuse_form(path);
    for (const Json& chapter : json)
      chapters.push_back({chapter.at("title"), chapter.at("about"), chapter.at("scenarios")});
  } catch (const Json::exception&) {
    refuse_form(path);
  }
  return chapters;
}

bool is_folder(const std::string& entry) { return entry.ends_with("/*"); }

/// Those of a folder that nobody has named and none has taken.
std::vector<std::string> rest_of(const std::string& entry, const std::vector<std::string>& ids,
                                 std::set<std::string>& taken) {
  const std::string folder = entry.substr(0, entry.size() - 1);
  std::vector<std::string> rest;
  for (const std::string& id : ids) {
    if (id.starts_with(folder) && taken.insert(id).second) rest.push_back(id);
  }
  return rest;
}

/// The ids that the chapters name one by one, each of which must be there.
std::set<std::string> named_in(const std::vector<GalleryChapter>& chapters, const std::vector<std::string>& ids,
                               const std::string& path) {
  std::set<std::string> named;
  for (const GalleryChapter& chapter : chapters) {
    for (const std::string& id : chapter.ids) {
      if (is_folder(id)) continue;
      if (std::find(ids.begin(), ids.end(), id) == ids.end())
        throw ScenarioError(path + ": there is no scenario " + quote(id) + ", " + did_you_mean(id, ids));
      if (!named.insert(id).second) throw ScenarioError(path + ": names the scenario " + quote(id) + " twice");
    }
  }
  return named;
}

}  // namespace

std::vector<GalleryChapter> gallery_chapters(const std::string& folder, const std::vector<std::string>& ids) {
  const std::string path = (std::filesystem::path(folder) / "contents.json").string();
  std::vector<GalleryChapter> chapters = chapters_in(path);
  std::set<std::string> taken = named_in(chapters, ids, path);
  for (GalleryChapter& chapter : chapters) {
    std::vector<std::string> all;
    for (const std::string& id : chapter.ids) {
      const std::vector<std::string> meant = is_folder(id) ? rest_of(id, ids, taken) : std::vector{id};
      all.insert(all.end(), meant.begin(), meant.end());
    }
    chapter.ids = std::move(all);
  }
  GalleryChapter rest{"More", "What belongs to no chapter yet.", rest_of("*", ids, taken)};
  if (!rest.ids.empty()) chapters.push_back(std::move(rest));
  return chapters;
}

}  // namespace proofreel
