#pragma once

#include <optional>
#include <string>

#include "golden/json.h"
#include "lab/study.h"
#include "lab/study_work.h"
#include "render/context.h"

namespace proofreel {

/// What is known of all runs, as JSON: scenario, measures, energy_scale_j, verdict, methods [{name, engine, order,
/// floor}], runs [{method, set, status, why, errors {measure: error}, energy_error, cpu_s, cpu_ms_per_s, row_updates,
/// evaluations, instructions, on_front}], left_out. What is not known is null.
Json json_of(const Study& study, const StudyOutcome& outcome);

/// Writes into the folder: study.json, study.html, and as PNG and SVG work_precision (by CPU time),
/// work_precision_updates, work_precision_instructions, error_over_time, energy_drift, phase_portrait, as far as there
/// is something to show. Throws EnvironmentError.
void write_study_files(const Study& study, const StudyOutcome& outcome, const StudyWork& work,
                       std::optional<GlBackend> gl, const std::string& command, const std::string& version);

}  // namespace proofreel
