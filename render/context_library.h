#pragma once

/// A library loaded while the program runs, and functions found in it by name.

#include <string>
#include <vector>

namespace proofreel {

class LoadedLibrary {
 public:
  /// Loads the first of `names` that the system has. Throws EnvironmentError that names them all; `package` is what to
  /// install.
  LoadedLibrary(const std::vector<std::string>& names, const std::string& package);

  /// The function `name`, which has the type `Function`. Throws EnvironmentError when the library lacks it.
  template <typename Function>
  Function* function(const char* name) const {
    return reinterpret_cast<Function*>(symbol(name));
  }

 private:
  void* symbol(const char* name) const;

  // Never closed: Mesa's worker threads may still run its code after the last context is gone.
  void* handle_ = nullptr;
  std::string name_;
};

}  // namespace proofreel
