#include "render/context_library.h"

#include <dlfcn.h>

#include "scenarios/environment_error.h"

namespace proofreel {

LoadedLibrary::LoadedLibrary(const std::vector<std::string>& names, const std::string& package) {
  std::string problems;
  for (const std::string& name : names) {
    handle_ = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle_ != nullptr) {
      name_ = name;
      return;
    }
    problems += (problems.empty() ? "" : "; ") + std::string(dlerror());
  }
  throw EnvironmentError("cannot load it (" + problems + "); install " + package);
}

void* LoadedLibrary::symbol(const char* name) const {
  void* found = dlsym(handle_, name);
  if (found == nullptr) throw EnvironmentError(name_ + " has no function " + name);
  return found;
}

}  // namespace proofreel
