#pragma once

/// What pages are put together from. They need nothing from elsewhere, and can be read in light and dark, by keyboard
/// and by ear.

#include <string>
#include <string_view>

namespace proofreel {

/// `text` as it may stand in HTML and XML, attributes in double quotes included.
std::string html_escaped(std::string_view text);

/// An element; content and attributes are HTML.
std::string tag(const std::string& name, const std::string& content, const std::string& attributes = {});
/// name="value", escaped.
std::string attribute(const std::string& name, std::string_view value);

}  // namespace proofreel
