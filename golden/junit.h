#pragma once

#include <string>

#include "golden/report.h"

namespace proofreel {

/// The report as JUnit XML, which CI servers show as tests: an entry is a suite, an item a case. What could not be
/// checked is an error, what did not pass a failure whose type is the verdict.
std::string junit_of(const Report& report);

}  // namespace proofreel
