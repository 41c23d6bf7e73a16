#pragma once

#include <utility>

#include "engine/simulation.h"

namespace proofreel {

/// The smaller id first, as the engine has it. The tangential impulse stays: normal and tangent both turn round, and so
/// do the bodies.
inline ContactView in_order(ContactView view) {
  if (view.b < view.a) {
    std::swap(view.a, view.b);
    view.normal = -view.normal;
  }
  return view;
}

inline SeparationEvent separation_of(const ContactView& view) { return {view.a, view.b}; }

/// What the first tick of a contact is told as.
inline ContactEvent event_of(const ContactView& view) {
  ContactEvent event{view.a, view.b, view.points[0].point, view.normal};
  for (int i = 0; i < view.point_count; ++i) event.impulse += view.points[i].normal_impulse;
  return event;
}

}  // namespace proofreel
