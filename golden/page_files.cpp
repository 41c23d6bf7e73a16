#include "golden/page_files.h"

// The assembler copies the files as they are. PROOFREEL_PAGE is their folder.
#define PROOFREEL_EMBED(name, file)        \
  asm(".section .rodata\n"                 \
      ".global proofreel_" name            \
      "\n"                                 \
      "proofreel_" name                    \
      ":\n"                                \
      ".incbin \"" PROOFREEL_PAGE "/" file \
      "\"\n"                               \
      ".byte 0\n"                          \
      ".previous\n")

PROOFREEL_EMBED("base_css", "base.css");
PROOFREEL_EMBED("report_html", "report.html");
PROOFREEL_EMBED("report_css", "report.css");
PROOFREEL_EMBED("report_pictures_css", "report_pictures.css");
PROOFREEL_EMBED("report_js", "report.js");
PROOFREEL_EMBED("report_pictures_js", "report_pictures.js");
PROOFREEL_EMBED("report_start_js", "report_start.js");

extern "C" const char proofreel_base_css[];
extern "C" const char proofreel_report_html[];
extern "C" const char proofreel_report_css[];
extern "C" const char proofreel_report_pictures_css[];
extern "C" const char proofreel_report_js[];
extern "C" const char proofreel_report_pictures_js[];
extern "C" const char proofreel_report_start_js[];

namespace proofreel {

std::string_view base_style() { return proofreel_base_css; }
std::string_view report_frame() { return proofreel_report_html; }
std::string report_style() { return std::string(proofreel_report_css) + proofreel_report_pictures_css; }
std::string report_script() {
  return std::string(proofreel_report_js) + proofreel_report_pictures_js + proofreel_report_start_js;
}

}  // namespace proofreel
