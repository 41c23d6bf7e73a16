#pragma once

namespace proofreel {

/// The typeface of all pictures, DejaVu Sans, as a TrueType file compiled into the program: pictures must not depend on
/// the fonts of the machine. Never freed.
const unsigned char* font_file();

}  // namespace proofreel
