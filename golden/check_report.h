#pragma once

/// What a check of scenarios found, as a report.

#include <string>

#include "golden/check.h"
#include "golden/report.h"

namespace proofreel {

/// Findings first, one item each in their order, then the expectations. Pictures are left to a ReportFolder.
ReportEntry entry_of(const CheckResult& check);

/// Something that could not be checked, and why.
ReportEntry entry_of_error(const std::string& name, const std::string& message);

/// A reference no scenario asks for.
ReportEntry entry_of_orphan(const GoldenStore& store, const std::string& id);

}  // namespace proofreel
