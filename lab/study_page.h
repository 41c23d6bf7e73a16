#pragma once

#include <string>
#include <vector>

#include "lab/score_page.h"
#include "lab/study.h"
#include "lab/study_work.h"

namespace proofreel {

/// A figure of the page, as SVG.
struct PageFigure {
  std::string svg;
  std::string caption;
};

/// The study as one HTML page that needs nothing else: the verdict, the figures with values to point at, who is
/// cheapest for which error, a table of all runs that can be sorted, the rules that make it fair, and who was left out
/// and why.
std::string page_of(const Study& study, const StudyOutcome& outcome, const std::vector<PageFigure>& figures,
                    const PageFacts& facts);

}  // namespace proofreel
