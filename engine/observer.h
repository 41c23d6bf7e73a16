#pragma once

/// Algorithms that are taught tell what they do, step by step, to whoever watches: a lecture film is drawn from these
/// events of the real run, so it cannot show anything else. The observer is a template parameter. Without one, the
/// code that would make an event is never called and leaves no instruction behind.

#include <functional>
#include <memory>
#include <utility>

#include "engine/events.h"

namespace proofreel {

/// Nobody watches. An algorithm tells an event by
///     if constexpr (Observer::watches) observer([&] { return CornerTested{...}; });
/// and without an observer that statement is not compiled at all.
struct NoObserver {
  static constexpr bool watches = false;
};

/// Hands every event on, in the order things happen. Passed by value, like NoObserver, which then is not even an
/// argument; all copies share one sink.
class Observer {
 public:
  static constexpr bool watches = true;

  explicit Observer(std::function<void(const Event&)> sink)
      : sink_(std::make_shared<const std::function<void(const Event&)>>(std::move(sink))) {}

  /// `make_event` is a function without arguments that returns one of the structs of events.h. Whatever only the
  /// picture needs is computed inside it.
  template <typename MakeEvent>
  void operator()(const MakeEvent& make_event) const {
    (*sink_)(make_event());
  }

 private:
  std::shared_ptr<const std::function<void(const Event&)>> sink_;
};

}  // namespace proofreel
