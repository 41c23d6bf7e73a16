#pragma once

/// Instructions counted by valgrind: the same number in every run and on a busy machine, which no clock can promise.

#include <cstdint>
#include <string>
#include <vector>

namespace proofreel {

/// Runs a command to its end and counts the instructions executed while inside a function whose name (as valgrind
/// shows it) `inside` matches, with * for any characters; 0 when it is never called. What the command prints is thrown
/// away. Throws EnvironmentError when valgrind is not installed or the command fails.
std::int64_t instructions(const std::vector<std::string>& command, const std::string& inside);

}  // namespace proofreel
