#pragma once

/// A study's results as charts.

#include <optional>
#include <string>
#include <vector>

#include "lab/chart.h"
#include "lab/study.h"
#include "lab/study_analysis.h"
#include "lab/study_run.h"

namespace proofreel {

/// Error of the first measure against work, both logarithmic: what is cheapest for its error, what is dominated, what
/// failed, which order the methods have and where they get no better. Nothing when the work is known of no run.
std::optional<Chart> work_precision_chart(const Study& study, const std::vector<StudyResult>& results, WorkAxis axis);

/// The runs that are compared on the way: of each method the one whose CPU time is nearest to what they all can spend.
std::vector<std::size_t> runs_of_equal_cost(const Study& study, const std::vector<StudyResult>& results);

/// Error of the first measure, and deviation of the energy, against time.
Chart error_chart(const Study& study, const std::vector<std::size_t>& runs, const std::vector<Trace>& traces);
Chart energy_chart(const Study& study, const std::vector<std::size_t>& runs, const std::vector<Trace>& traces,
                   double energy_scale_j);
/// The second measure against the first one; nothing for a study of one measure.
std::optional<Chart> phase_chart(const Study& study, const std::vector<std::size_t>& runs,
                                 const std::vector<Trace>& traces);

/// What a measure's errors are taken against, as a sentence.
std::string reference_words(const Study& study);

/// All that is known of a run, in a sentence: for who points at it.
std::string words_of(const Study& study, const StudyRun& run, const StudyResult& result);

}  // namespace proofreel
