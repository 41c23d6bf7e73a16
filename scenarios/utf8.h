#pragma once

#include <string_view>

namespace proofreel {

/// Whether `text` is well-formed UTF-8 without control characters other than line breaks and tabs: only then can it be
/// drawn, and written into JSON and XML.
bool is_plain_text(std::string_view text);

}  // namespace proofreel
