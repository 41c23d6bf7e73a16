#include "lab/gallery.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <set>

#include "scenarios/source.h"
#include "tests/scenarios/scene_text.h"

using namespace proofreel;
using Catch::Contains;

namespace {

namespace fs = std::filesystem;

const std::vector<std::string> ids{"a", "b", "hard/x", "hard/y", "lecture/l"};

std::vector<GalleryChapter> chapters_of(const std::string& json, const std::vector<std::string>& all = ids) {
  const ScratchFolder folder;
  folder.write("contents.json", json);
  return gallery_chapters(folder.path(), all);
}

std::string chapter(const std::string& scenarios) {
  return R"({"title": "T", "about": "A", "scenarios": [)" + scenarios + "]}";
}

/// All scenarios of the collection, by id.
std::vector<std::string> collected() {
  std::vector<std::string> all;
  for (const std::string& path : all_scenarios()) all.push_back(id_of(path));
  return all;
}

/// What is left of HTML without its tags.
std::string plain(const std::string& html) {
  std::string text;
  bool inside = false;
  for (const char c : html) {
    if (c == '<') inside = true;
    if (!inside) text += c;
    if (c == '>') inside = false;
  }
  for (const auto& [entity, letter] :
       {std::pair{"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&#39;", "'"}, {"&amp;", "&"}}) {
    for (std::size_t at = 0; (at = text.find(entity, at)) != std::string::npos; ++at)
      text.replace(at, std::string(entity).size(), letter);
  }
  return text;
}

}  // namespace

TEST_CASE(
    "Chapters hold what they name, in that order, a folder what nobody else names of it, and the rest comes last") {
  const auto chapters = chapters_of("[" + chapter(R"("b", "hard/*")") + "," + chapter(R"("hard/x")") + "]");
  REQUIRE(chapters.size() == 3);
  CHECK(chapters[0].ids == std::vector<std::string>{"b", "hard/y"});
  CHECK(chapters[1].ids == std::vector<std::string>{"hard/x"});
  CHECK(chapters[2].title == "More");
  CHECK(chapters[2].ids == std::vector<std::string>{"a", "lecture/l"});
}

TEST_CASE("Contents that cannot be are refused with a sentence that names the file") {
  CHECK_THROWS_WITH(chapters_of("[" + chapter(R"("hard/z")") + "]"),
                    Contains("contents.json: there is no scenario \"hard/z\", did you mean"));
  CHECK_THROWS_WITH(chapters_of("[" + chapter(R"("a", "a")") + "]"), Contains("names the scenario \"a\" twice"));
  CHECK_THROWS_WITH(chapters_of("[{}]"), Contains("must be a list of chapters"));
  CHECK_THROWS_WITH(chapters_of("[1]"), Contains("must be a list of chapters"));
  CHECK_THROWS_WITH(chapters_of("{}"), Contains("must be a list of chapters"));
  CHECK_THROWS_WITH(chapters_of("null"), Contains("must be a list of chapters"));
  CHECK_THROWS_WITH(chapters_of("["), Contains("line 1 is no JSON"));
  const ScratchFolder empty;
  CHECK_THROWS_WITH(gallery_chapters(empty.path(), ids),
                    Catch::StartsWith("There is no ") && Contains("contents.json"));
}

TEST_CASE("Every scenario of the collection has its chapter, once") {
  const std::vector<std::string> all = collected();
  std::set<std::string> seen;
  std::size_t count = 0;
  for (const GalleryChapter& chapter : gallery_chapters("scenarios", all)) {
    CHECK(chapter.title != "More");
    seen.insert(chapter.ids.begin(), chapter.ids.end());
    count += chapter.ids.size();
  }
  CHECK(count == all.size());
  CHECK(seen.size() == all.size());
}

TEST_CASE("What a scenario shows of the engine are files that are there") {
  std::set<std::string> files;
  for (const std::string& path : all_scenarios()) {
    const auto scenario = load_scenario(path, {});
    const std::vector<std::string> shown = engine_files_of(*scenario);
    if (!scenario->stories.empty()) CHECK_FALSE(shown.empty());
    files.insert(shown.begin(), shown.end());
  }
  CHECK(files.size() > 20);
  for (const std::string& file : files) {
    INFO(file);
    CHECK(fs::exists(file));
  }
}

TEST_CASE("Colours change no letter of a source") {
  for (const std::string& path : all_scenarios()) {
    INFO(path);
    const std::string source = read_source(path);
    CHECK(plain(highlighted_lua(source)) == source);
  }
}

TEST_CASE("Lua's comments, strings, numbers, keywords and called words are told apart") {
  const std::string html = highlighted_lua(
      "-- a 'b'\nlocal x = circle { radius = 1.5e3 } --[[ two\nlines ]] b:at(\"-- no\\\"\") [[ <end> ]]");
  CHECK_THAT(html,
             Contains("<span class=\"c\">-- a &#39;b&#39;</span>") || Contains("<span class=\"c\">-- a 'b'</span>"));
  CHECK_THAT(html, Contains("<span class=\"k\">local</span> x = <span class=\"w\">circle</span>"));
  CHECK_THAT(html, Contains("<span class=\"n\">1.5e3</span>"));
  CHECK_THAT(html, Contains("<span class=\"c\">--[[ two\nlines ]]</span> b:at("));
  CHECK_THAT(html, Contains("<span class=\"s\">&quot;-- no\\&quot;&quot;</span>"));
  CHECK_THAT(html, Contains("<span class=\"s\">[[ &lt;end&gt; ]]</span>"));
  CHECK(plain(highlighted_lua("x = 'open\n[==[ never closed ]=]")) == "x = 'open\n[==[ never closed ]=]");
}

TEST_CASE("The page has a thumbnail, the film, the source and the engine's files of every scenario") {
  GalleryEntry entry{"hard/x",       "A <title>",      "What it is", 20, 12, "films/hard/x.mp4", "stills/hard/x.png",
                     "scenario { }", {"engine/gjk.h"}, "hard/x"};
  const std::string page = gallery_page({{{"Hard & fast", "About", {"hard/x"}}, {entry}}}, "../..");
  CHECK_THAT(page, Contains("A &lt;title&gt;") && !Contains("A <title>"));
  CHECK_THAT(page, Contains("href=\"#hard/x\"") && Contains("id=\"hard/x\""));
  CHECK_THAT(page, Contains("src=\"stills/hard/x.png\"") && Contains("src=\"films/hard/x.mp4\""));
  CHECK_THAT(page, Contains("href=\"../../engine/gjk.h\"") && Contains("the first 12 of 20 s"));
  CHECK_THAT(page, Contains("<span class=\"w\">scenario</span> { }"));
  CHECK_THAT(page, !Contains("http://") && !Contains("https://"));
}

TEST_CASE("A page that lies beside no project names the engine's files and links nowhere") {
  const GalleryEntry entry{"x", "X", "", 1, 1, "films/x.mp4", "stills/x.png", "", {"engine/gjk.h"}, "my folder/x.lua"};
  const std::string page = gallery_page({{{"T", "A", {"x"}}, {entry}}}, "");
  CHECK_THAT(page, Contains("<code>engine/gjk.h</code>") && !Contains("href=\"/engine") && !Contains("href=\"engine"));
  CHECK_THAT(page, Contains("proofreel render 'my folder/x.lua' -o film.mp4") ||
                       Contains("proofreel render &#39;my folder/x.lua&#39; -o film.mp4"));
}
