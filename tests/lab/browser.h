#pragma once

/// Pages as a browser has them.

#include <catch2/catch.hpp>
#include <cstdlib>
#include <string>

#include "tests/render/scratch_folder.h"

namespace proofreel::test {

/// The page as a browser has it after `script` has run in it.
inline std::string in_browser(std::string html, const std::string& script) {
  const ScratchFolder folder;
  write_text(folder / "page.html", html.insert(html.rfind("</body>"), "<script>" + script + "</script>"));
  const std::string command =
      "timeout 60 chromium --headless --no-sandbox --disable-gpu --disable-background-networking "
      "--disable-component-update --disable-sync --no-first-run --user-data-dir=" +
      (folder / "profile") + " --dump-dom file://" + (folder / "page.html") + " >" + (folder / "dom.html") +
      " 2>/dev/null";
  INFO("This needs the Debian package chromium.");
  REQUIRE(std::system(command.c_str()) == 0);
  return read_text(folder / "dom.html");
}

}  // namespace proofreel::test
