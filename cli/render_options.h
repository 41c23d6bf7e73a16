#pragma once

/// The values of render's options, from the text users type. All throw UsageError with what would be right.

#include <optional>
#include <string>
#include <vector>

#include "render/contact_sheet.h"
#include "render/film.h"
#include "scenarios/scenario.h"

namespace proofreel {

/// "1280x720".
Size parse_size(const std::string& text);

/// "A:B", both included, or "A" alone; within a film of `film_length` frames.
FrameRange parse_frames(const std::string& text, std::int64_t film_length);

/// "a,b" are the layers; "+c,-d" adds to and takes from `present`.
std::vector<Layer> parse_layers(const std::string& text, const std::vector<Layer>& present);

/// The same at all times of the film.
void apply_layers(const std::string& text, Picture& picture);

Theme parse_theme(const std::string& text);

/// "3" or "2.5": seconds of a title card, up to a minute.
double parse_card_seconds(const std::string& text);

/// "4x3", columns and rows of a contact sheet; nothing for "auto".
std::optional<SheetGrid> parse_sheet_grid(const std::string& text);

}  // namespace proofreel
