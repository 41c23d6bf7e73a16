#include "lab/kept_traces.h"

#include <filesystem>
#include <fstream>
#include <iterator>

#include "render/output_file.h"

namespace proofreel {

KeptTraces::KeptTraces(const std::string& study_folder)
    : folder_((std::filesystem::path(study_folder) / "traces").string()) {
  make_folder(folder_);
}

std::optional<Trace> KeptTraces::find(const StudyRun& run) const {
  std::ifstream file(path_of(run), std::ios::binary);
  if (!file) return std::nullopt;
  return unpacked_trace({std::istreambuf_iterator<char>(file), {}});
}

void KeptTraces::keep(const StudyRun& run, const Trace& trace) const {
  if (trace.status == RunStatus::ended) write_file(path_of(run), packed(trace));
}

std::string KeptTraces::path_of(const StudyRun& run) const { return folder_ + "/" + run.key + ".trace"; }

}  // namespace proofreel
