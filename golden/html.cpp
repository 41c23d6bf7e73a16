#include "golden/html.h"

namespace proofreel {

std::string html_escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string tag(const std::string& name, const std::string& content, const std::string& attributes) {
  std::string text("<");
  text.append(name);
  if (!attributes.empty()) text.append(" ").append(attributes);
  return text.append(">").append(content).append("</").append(name).append(">");
}

std::string attribute(const std::string& name, std::string_view value) {
  return name + "=\"" + html_escaped(value) + "\"";
}

}  // namespace proofreel
