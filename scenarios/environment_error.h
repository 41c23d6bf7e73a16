#pragma once

#include <stdexcept>

namespace proofreel {

/// Something outside the scenario does not work: GL, an encoder, the disk. A sentence with what to install or do. Exit
/// status 3.
class EnvironmentError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace proofreel
