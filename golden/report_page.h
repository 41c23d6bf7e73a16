#pragma once

#include <string>

#include "golden/report.h"

namespace proofreel {

/// The report as one page that needs nothing but the pictures it names. It draws itself from the report's JSON, which
/// it contains.
std::string report_page(const Report& report);

}  // namespace proofreel
