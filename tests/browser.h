#pragma once

/// Pages as a browser has them.

#include <catch2/catch.hpp>
#include <cstdlib>
#include <string>

#include "tests/render/scratch_folder.h"

namespace proofreel::test {

/// The page in `folder` (index.html) as a browser has it five seconds after it was loaded, and with it its pictures;
/// `script` runs at its end. The seconds are the page's, not ours. `hash` follows the address.
inline std::string folder_in_browser(const std::string& folder, const std::string& script,
                                     const std::string& hash = {}) {
  const ScratchFolder scratch;
  const std::string page = folder + "/driven.html";
  std::string html = read_text(folder + "/index.html");
  write_text(page, html.insert(html.rfind("</body>"), "<script>" + script + "</script>"));
  const std::string command =
      "timeout 60 chromium --headless --no-sandbox --disable-gpu --disable-background-networking "
      "--disable-component-update --disable-sync --no-first-run --window-size=1280,900 --virtual-time-budget=5000 "
      "--user-data-dir=" +
      (scratch / "profile") + " --dump-dom 'file://" + page + hash + "' >" + (scratch / "dom.html") + " 2>/dev/null";
  INFO("This needs the Debian package chromium.");
  REQUIRE(std::system(command.c_str()) == 0);
  return read_text(scratch / "dom.html");
}

/// A page without pictures.
inline std::string in_browser(const std::string& html, const std::string& script) {
  const ScratchFolder folder;
  write_text(folder / "index.html", html);
  return folder_in_browser(folder.path().string(), script);
}

}  // namespace proofreel::test
