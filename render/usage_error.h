#pragma once

#include <stdexcept>

namespace proofreel {

/// Something was asked for that cannot be: a sentence that says what to ask instead. Exit status 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace proofreel
