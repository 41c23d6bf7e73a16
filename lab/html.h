#pragma once

/// What pages of tables and figures are put together from, beside golden/html.h.

#include <string>

#include "golden/html.h"

namespace proofreel {

/// A heading of a table that sorts its rows by column `column`; `label` is HTML.
std::string heading(const std::string& label, std::size_t column);

/// A table that scrolls by itself when it is wider than the page.
std::string scrolling(const std::string& table, const std::string& label);

/// A whole page with the house's style and scripts; `body` is HTML and follows the title.
std::string html_page(const std::string& title, const std::string& body);

/// The processor's name as the system tells it, or "an unnamed processor".
std::string machine_name();

}  // namespace proofreel
