#pragma once

/// What pages are put together from. They need nothing from elsewhere, and can be read in light and dark, by keyboard
/// and by ear.

#include <string>
#include <string_view>

namespace proofreel {

/// `text` as it may stand in HTML, attributes in double quotes included.
std::string html_escaped(std::string_view text);

/// An element; content and attributes are HTML.
std::string tag(const std::string& name, const std::string& content, const std::string& attributes = {});
/// name="value", escaped.
std::string attribute(const std::string& name, std::string_view value);

/// A heading of a table that sorts its rows by column `column`; `label` is HTML.
std::string heading(const std::string& label, std::size_t column);

/// A table that scrolls by itself when it is wider than the page.
std::string scrolling(const std::string& table, const std::string& label);

/// A whole page with the house's style and scripts; `body` is HTML and follows the title.
std::string html_page(const std::string& title, const std::string& body);

/// The processor's name as the system tells it, or "an unnamed processor".
std::string machine_name();

}  // namespace proofreel
