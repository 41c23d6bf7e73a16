// The gallery's page: a sheet of thumbnails, chapter by chapter, and below it every film beside its source.

#include "golden/html.h"
#include "golden/page_files.h"
#include "golden/plain_path.h"
#include "golden/shell.h"
#include "lab/gallery.h"
#include "lab/gallery_style.h"
#include "scenarios/formatted.h"

namespace proofreel {
namespace {

std::string anchor_of(const FilmedChapter& chapter) {
  return std::string("chapter-").append(plain_path(chapter.chapter.title));
}

std::string link(const std::string& to, const std::string& content) { return tag("a", content, attribute("href", to)); }

std::string navigation(const std::vector<FilmedChapter>& chapters) {
  std::string items;
  for (const FilmedChapter& chapter : chapters)
    items += tag("li", link(std::string("#").append(anchor_of(chapter)), html_escaped(chapter.chapter.title)));
  return tag("nav", tag("ol", items), attribute("aria-label", "Chapters")).append("\n");
}

std::string thumbnail(const GalleryEntry& entry) {
  const std::string picture =
      "<img loading=\"lazy\" alt=\"\" width=\"480\" height=\"270\" " + attribute("src", entry.still) + ">";
  return tag("li", tag("a", picture + tag("span", html_escaped(entry.title)),
                       attribute("href", std::string("#").append(plain_path(entry.id))) + " " +
                           attribute("data-film", entry.film))) +
         "\n";
}

std::string sheet(const FilmedChapter& chapter) {
  std::string items;
  for (const GalleryEntry& entry : chapter.entries) items += thumbnail(entry);
  return tag("section",
             tag("h2", html_escaped(chapter.chapter.title)) +
                 tag("p", html_escaped(chapter.chapter.about), "class=\"quiet\"") + tag("ul", items, "class=\"sheet\""),
             attribute("id", anchor_of(chapter))) +
         "\n";
}

std::string length_of(const GalleryEntry& entry) {
  if (entry.clip_s < entry.film_s)
    return std::string("the first ") + formatted("%.3g", entry.clip_s) + " of " + formatted("%.3g", entry.film_s) +
           " s";
  return formatted("%.3g", entry.film_s) + " s";
}

std::string links_of(const GalleryEntry& entry, const std::string& to_project) {
  std::string text =
      html_escaped(length_of(entry)) + " \u00b7 " +
      tag("code",
          html_escaped(std::string("proofreel render ").append(shell_word(entry.argument)).append(" -o film.mp4")));
  const char* gap = " \u00b7 in the engine: ";
  for (const std::string& file : entry.engine_files) {
    const std::string name = tag("code", html_escaped(file));
    text += gap + (to_project.empty() ? name : link(to_project + "/" + file, name));
    gap = ", ";
  }
  return tag("p", text, "class=\"links\"");
}

std::string article(const GalleryEntry& entry, const std::string& to_project) {
  const std::string film = "<video controls preload=\"none\" playsinline " + attribute("poster", entry.still) + " " +
                           attribute("src", entry.film) + " " +
                           attribute("aria-label", std::string("Film: ").append(entry.title)) + "></video>";
  const std::string source =
      tag("pre", tag("code", highlighted_lua(entry.source)),
          std::string("tabindex=\"0\" ")
              .append(attribute("aria-label", std::string("Source of ").append(entry.id).append(".lua"))));
  return tag("article",
             tag("h3", html_escaped(entry.title)) + tag("p", html_escaped(entry.description)) +
                 tag("div", film + source, "class=\"pair\"") + links_of(entry, to_project),
             attribute("id", plain_path(entry.id))) +
         "\n";
}

std::string films(const FilmedChapter& chapter, const std::string& to_project) {
  std::string text = tag("h2", html_escaped(chapter.chapter.title));
  for (const GalleryEntry& entry : chapter.entries) text += article(entry, to_project);
  return tag("section", text) + "\n";
}

}  // namespace

std::string gallery_page(const std::vector<FilmedChapter>& chapters, const std::string& to_project) {
  std::string sheets, all_films;
  std::size_t count = 0;
  for (const FilmedChapter& chapter : chapters) {
    sheets += sheet(chapter);
    all_films += films(chapter, to_project);
    count += chapter.entries.size();
  }
  std::string page = "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n";
  page +=
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>Proofreel: gallery</title>\n";
  page += tag("style", std::string(base_style()).append(gallery_style)) + "\n</head>\n<body>\n";
  page += tag("header",
              tag("h1", "Proofreel: gallery") +
                  tag("p",
                      std::to_string(count) +
                          " scenarios as films, each beside the Lua source it is made of. Point at a picture to see it "
                          "move; follow it to the film and its source.",
                      "class=\"quiet\""));
  page.append("\n").append(navigation(chapters));
  page += tag("main", sheets + all_films);
  page +=
      tag("footer", tag("p",
                        "Made by <code>proofreel gallery</code>. Everything on this page lies in its folder; nothing "
                        "comes from a network."));
  return page + tag("script", gallery_script) + "\n</body>\n</html>\n";
}

}  // namespace proofreel
