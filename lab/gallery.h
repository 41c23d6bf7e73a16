#pragma once

/// The gallery: every scenario as a film with its source beside it, on one page that needs no network.
///
///     contents.json -> chapters of ids -> film_for_gallery, one by one -> gallery_page

#include <optional>
#include <string>
#include <vector>

#include "render/context.h"
#include "render/film.h"
#include "scenarios/scenario.h"

namespace proofreel {

/// A chapter of the gallery and the scenarios in it, in the order they are shown in.
struct GalleryChapter {
  std::string title;
  std::string about;  ///< a sentence for the reader
  std::vector<std::string> ids;
};

/// The chapters that DIR/contents.json lists, DIR being a folder of scenarios, with the ids that exist: an entry
/// "hard/*" stands for all of a folder that no other entry names. What no entry stands for makes a last chapter. Throws
/// ScenarioError, naming the file, when it cannot be read or names a scenario that is not there.
std::vector<GalleryChapter> gallery_chapters(const std::string& folder, const std::vector<std::string>& ids);

/// A scenario that is to be in the gallery.
struct GalleryScenario {
  std::string file;
  std::string id;        ///< its path below the folder of scenarios, without .lua
  std::string argument;  ///< what `proofreel render` calls it
};

/// One scenario, filmed.
struct GalleryEntry {
  std::string id;
  std::string title;
  std::string description;
  double film_s = 0;  ///< how long the whole film is
  double clip_s = 0;  ///< how much of it was filmed: films with sections whole, of others the beginning
  std::string film;   ///< file names, below the gallery's folder
  std::string still;
  std::string source;                     ///< the Lua text
  std::vector<std::string> engine_files;  ///< what of the engine it shows at work: "engine/gjk.h"
  std::string argument;                   ///< what `proofreel render` calls it
};

/// Makes the folder of a gallery, with a page that says that it is not finished. Throws UsageError when the folder is
/// not empty and holds no gallery, EnvironmentError when it cannot be written.
void open_gallery(const std::string& folder);

/// Films the scenario for the gallery in `folder` (which exists): films/ID.mp4 and a telling moment as stills/ID.png,
/// ID as plain_path has it. `progress` may throw to stop. Throws ScenarioError and EnvironmentError.
GalleryEntry film_for_gallery(const GalleryScenario& which, const std::vector<Override>& overrides,
                              const std::string& folder, std::optional<GlBackend> gl, const Progress& progress);

/// What of the engine a scene shows at work: the files of the algorithms it demonstrates, or of its joints and effects.
std::vector<std::string> engine_files_of(const Scenario& scenario);

/// A chapter with what was filmed of it.
struct FilmedChapter {
  GalleryChapter chapter;
  std::vector<GalleryEntry> entries;
};

/// The page. `to_project` leads from the gallery's folder to the project's, for links to files of the engine; where it
/// is empty they are named and not linked.
std::string gallery_page(const std::vector<FilmedChapter>& chapters, const std::string& to_project);

/// Lua as HTML: comments (c), strings (s), numbers (n), keywords (k) and words that are called (w) in spans of that
/// class.
std::string highlighted_lua(const std::string& text);

}  // namespace proofreel
