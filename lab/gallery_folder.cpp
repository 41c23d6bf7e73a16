// The folder of a gallery: nobody else's files are touched.

#include <filesystem>
#include <fstream>

#include "golden/html.h"
#include "lab/gallery.h"
#include "render/output_file.h"
#include "render/usage_error.h"

namespace proofreel {
namespace {

namespace fs = std::filesystem;

constexpr const char* page_title = "<title>Proofreel: gallery</title>";

fs::path page_in(const std::string& folder) { return fs::path(folder) / "index.html"; }

bool is_gallery(const std::string& folder) {
  constexpr std::size_t beginning = 400;
  std::string text(beginning, '\0');
  std::ifstream file(page_in(folder), std::ios::binary);
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  return text.find(page_title) != std::string::npos;
}

}  // namespace

void open_gallery(const std::string& folder) {
  make_folder(folder);
  if (is_gallery(folder)) return;
  if (!fs::is_empty(folder))
    throw UsageError("The folder " + folder + " holds other things than a gallery: name a new or an empty one.");
  const std::string text = "This gallery is being made, or was stopped half way: make it again.";
  write_file(page_in(folder).string(), std::string("<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n") +
                                           page_title + "\n" + tag("p", text) + "\n</html>\n");
}

}  // namespace proofreel
