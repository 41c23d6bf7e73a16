#pragma once

/// Works a study off: errors first, as many runs at a time as there are cores, and then times, one run alone.

#include <string>
#include <vector>

#include "lab/children.h"
#include "lab/study.h"
#include "lab/study_run.h"

namespace proofreel {

struct StudyWork {
  std::string folder;         ///< where its table goes, as study.csv
  double limit_s = 10;        ///< CPU seconds a run may take
  int at_once = 1;            ///< runs at a time while errors are looked at
  bool instructions = false;  ///< whether they are counted too
  std::string program;        ///< that steps a run under valgrind
};

struct StudyOutcome {
  std::vector<StudyResult> results;  ///< of Study::runs
  double energy_scale_j = 0;         ///< what energy errors are divided by: the largest kinetic energy of the scene
};

/// Every run that ends is written down at once, so that whoever stops this and starts it again goes on where it was.
/// `phase` is told what is being done, `progress` how much of it. Throws UsageError and EnvironmentError.
StudyOutcome work_off(const Study& study, const StudyWork& work, const std::function<void(const char*)>& phase,
                      const WorkProgress& progress);

/// The traces of some runs, measured anew, with what they should be where a method is compared with itself.
std::vector<Trace> traces_of(const Study& study, const std::vector<std::size_t>& runs, const StudyWork& work,
                             const WorkProgress& progress);

}  // namespace proofreel
