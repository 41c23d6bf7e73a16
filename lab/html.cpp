#include "lab/html.h"

#include <fstream>

#include "golden/page_files.h"
#include "lab/page_style.h"

namespace proofreel {
namespace {

std::string sort_button(const std::string& label, std::size_t column) {
  return tag("button", label, "type=\"button\" " + attribute("data-column", std::to_string(column)));
}

}  // namespace

std::string heading(const std::string& label, std::size_t column) {
  return tag("th", sort_button(label, column), "scope=\"col\"");
}

std::string scrolling(const std::string& table, const std::string& label) {
  return tag("div", table, "class=\"scroll\" tabindex=\"0\" role=\"region\" " + attribute("aria-label", label)) + "\n";
}

std::string machine_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "an unnamed processor";
}

std::string html_page(const std::string& title, const std::string& body) {
  std::string page = "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n";
  page += "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n";
  page += tag("title", html_escaped(title)) + "\n" + tag("style", std::string(base_style()).append(page_style)) +
          "\n</head>\n<body>\n";
  page += tag("h1", html_escaped(title)) + "\n" + body;
  return page + tag("script", page_script) + "\n</body>\n</html>\n";
}

}  // namespace proofreel
