#pragma once

/// Commands as people can paste them.

#include <string>

namespace proofreel {

/// A word as a shell takes it: in quotes where it must be.
std::string shell_word(const std::string& word);

/// How this program was called; `name` stands for where it lies, unless it is empty.
std::string command_line(const std::string& name = {});

}  // namespace proofreel
