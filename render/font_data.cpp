#include "render/font_data.h"

// The assembler copies the file as it is; as an array in C++ it would take the compiler half a minute.
// PROOFREEL_FONT is its path, found by CMake.
asm(".section .rodata\n"
    ".global proofreel_font_file\n"
    ".balign 16\n"
    "proofreel_font_file:\n"
    ".incbin \"" PROOFREEL_FONT
    "\"\n"
    ".byte 0\n"
    ".previous\n");

extern "C" const unsigned char proofreel_font_file[];

namespace proofreel {

const unsigned char* font_file() { return proofreel_font_file; }

}  // namespace proofreel
