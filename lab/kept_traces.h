#pragma once

/// Runs that a study measures beside its own (the finer ones that methods are compared with, those its figures over
/// time show), kept in files: whoever stops a study and starts it again does not wait for them twice.

#include <optional>
#include <string>

#include "lab/study_run.h"

namespace proofreel {

class KeptTraces {
 public:
  /// In the folder `traces` of the study's own folder, which is made.
  explicit KeptTraces(const std::string& study_folder);
  /// What is known of a run, by its key; nothing when there is no whole file of it.
  std::optional<Trace> find(const StudyRun& run) const;
  /// Keeps what came to its end; all else may come out otherwise next time. Throws EnvironmentError.
  void keep(const StudyRun& run, const Trace& trace) const;

 private:
  std::string path_of(const StudyRun& run) const;

  std::string folder_;
};

}  // namespace proofreel
