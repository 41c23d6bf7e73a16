#pragma once

/// In which order to eliminate the unknowns of a sparse symmetric system so that its factors stay sparse.

#include <vector>

namespace proofreel {

/// When each one's turn is, from 0. `neighbours` are the ones it shares an entry with, ascending, without itself.
/// Always the one with the fewest neighbours left comes next, the first of several; then all its neighbours become
/// neighbours of each other, since eliminating it fills these entries (minimum degree: Tinney and Walker 1967).
std::vector<int> elimination_turns(std::vector<std::vector<int>> neighbours);

}  // namespace proofreel
