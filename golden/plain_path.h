#pragma once

#include <string>

namespace proofreel {

/// A name as a path that is the same in a URL, and leads nowhere else; a hash keeps apart what would become the same.
/// What is plain already, such as "hard/stack_2", stays as it is.
std::string plain_path(const std::string& name);

}  // namespace proofreel
