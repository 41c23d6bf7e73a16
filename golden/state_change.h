#pragma once

/// What differs between the bodies of a golden frame and those of today's.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "golden/observe.h"
#include "golden/store.h"

namespace proofreel {

/// What users call bodies: by name, with the number where two share one or where it has none.
class BodyNames {
 public:
  void add(const std::vector<BodyPose>& bodies);
  std::string of(std::uint32_t body) const;
  std::uint32_t largest_id() const;  ///< 0 without any

 private:
  std::map<std::uint32_t, std::string> names_;
  std::map<std::string, int> uses_;
};

struct BodyMove {
  std::uint32_t body = 0;
  double distance = 0;  ///< m
  double turn = 0;      ///< rad, without a sign
};

struct StateChange {
  std::vector<BodyMove> moved;          ///< the farthest first
  std::vector<std::uint32_t> appeared;  ///< bodies that are there now only
  std::vector<std::uint32_t> gone;      ///< bodies that were there then only
  std::vector<Touch> met;               ///< pairs that touch now only
  std::vector<Touch> parted;            ///< pairs that touched then only

  /// What became of a body, such as "moved 0.41 m, turned 12 deg"; empty when nothing did.
  std::string fate_of(std::uint32_t body) const;
};

StateChange change_between(const GoldenFrame& then, const ObservedFrame& now);

/// What changed, the most telling first, as a sentence without its end.
std::string sentence_about(const StateChange& change, const BodyNames& names);

}  // namespace proofreel
