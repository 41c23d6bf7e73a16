#include "golden/report_page.h"

#include "golden/page_files.h"

namespace proofreel {
namespace {

/// JSON as it may stand in a script element: nothing in it can end that.
std::string script_safe(const std::string& json) {
  std::string out;
  for (const char c : json) out += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return out;
}

std::string value_of(std::string_view name, const Report& report) {
  if (name == "title") return report.failed() > 0 ? std::to_string(report.failed()) + " failed" : "All passed";
  if (name == "style") return std::string(base_style()).append(report_style());
  if (name == "data") return script_safe(to_json_text(report));
  return report_script();
}

}  // namespace

std::string report_page(const Report& report) {
  std::string page;
  std::string_view rest = report_frame();
  for (std::size_t at = rest.find("{{"); at != std::string_view::npos; at = rest.find("{{")) {
    const std::size_t end = rest.find("}}", at);
    page.append(rest.substr(0, at)).append(value_of(rest.substr(at + 2, end - at - 2), report));
    rest.remove_prefix(end + 2);
  }
  return page.append(rest);
}

}  // namespace proofreel
