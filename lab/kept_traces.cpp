#include "lab/kept_traces.h"

#include <filesystem>

#include "golden/file_text.h"
#include "render/output_file.h"

namespace proofreel {

KeptTraces::KeptTraces(const std::string& study_folder)
    : folder_((std::filesystem::path(study_folder) / "traces").string()) {
  make_folder(folder_);
}

std::optional<Trace> KeptTraces::find(const StudyRun& run) const {
  const std::optional<std::string> text = file_text(path_of(run));
  return text ? unpacked_trace(*text) : std::nullopt;
}

void KeptTraces::keep(const StudyRun& run, const Trace& trace) const {
  if (trace.status == RunStatus::ended) write_file(path_of(run), packed(trace));
}

std::string KeptTraces::path_of(const StudyRun& run) const { return folder_ + "/" + run.key + ".trace"; }

}  // namespace proofreel
