#pragma once

/// The same scene under two to six methods at once, and below them, in step, how their errors grow.

#include <optional>
#include <vector>

#include "lab/study.h"
#include "lab/study_run.h"
#include "render/context.h"
#include "render/film.h"
#include "render/sink.h"

namespace proofreel {

inline constexpr std::size_t fewest_filmed = 2;
inline constexpr std::size_t most_filmed = 6;
inline constexpr Size study_film_size{1920, 1080};

/// Films these runs of the study (their traces tell the errors) into `sink`, which takes pictures of
/// `study_film_size` and is finished at the end. A pane shows what its run has come to at the frame's time. Throws
/// EnvironmentError.
void film_study(const Study& study, const std::vector<std::size_t>& runs, const std::vector<Trace>& traces,
                std::optional<GlBackend> gl, Sink& sink, const Progress& progress);

/// Frames per second of such a film: the scenario's.
int fps_of(const Study& study);

}  // namespace proofreel
