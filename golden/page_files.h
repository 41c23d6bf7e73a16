#pragma once

#include <string>
#include <string_view>

namespace proofreel {

/// The files of golden/page/, compiled into the program.
std::string_view base_style();    ///< base.css: what all pages have in common
std::string_view report_frame();  ///< report.html: the page of a check, with {{title}}, {{style}}, {{data}}, {{script}}
std::string report_style();       ///< report*.css
std::string report_script();      ///< report*.js, in the order they need each other

}  // namespace proofreel
