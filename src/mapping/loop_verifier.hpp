// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Whether two submaps are one place, asked strictly: what merely looks alike must not pass.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "mapping/free_space.hpp"
#include "mapping/submap_registration.hpp"

namespace surefoot::mapping {

/// A submap made ready to be verified with.
class VerifiableSubmap {
 public:
  explicit VerifiableSubmap(Submap submap) : submap_(std::move(submap)), registration_(submap_) {}

  [[nodiscard]] const Submap& submap() const { return submap_; }
  [[nodiscard]] const RegistrationSubmap& registration() const { return registration_; }
  /// Made when it is first asked for.
  [[nodiscard]] const FreeSpace& free_space() const {
    if (!free_space_) free_space_ = std::make_unique<FreeSpace>(submap_);
    return *free_space_;
  }

 private:
  Submap submap_;
  RegistrationSubmap registration_;
  mutable std::unique_ptr<FreeSpace> free_space_;
};

/// Why a loop was taken or refused, in the order in which it is asked.
enum class LoopVerdict {
  taken,
  little_to_see,    ///< too few points stand upright
  no_overlap,       ///< too few of them lie on something of the other, or of floors and ceilings
  starts_disagree,  ///< registration ended elsewhere from another start, or the other way round
  bent,             ///< the odometry was not sure of its own way within one of them
  free_space,       ///< something stands where the other one saw that there is nothing
  beyond_drift,     ///< the odometry cannot have gone so far astray
  other_storey,     ///< under a roof, and higher or lower by more than half a storey
  ambiguous,        ///< another place fits as well, or this one otherwise
  alone,            ///< no other loop agrees
  outvoted,         ///< more loops agree on something else
  strains,          ///< the odometry would have to be bent beyond its own bounds
  not_joined        ///< between two maps: all loops together do not tell surely how they lie
};
[[nodiscard]] std::string_view to_string(LoopVerdict verdict);
/// A sentence for a user.
[[nodiscard]] std::string_view explain(LoopVerdict verdict);

struct LoopLimits {
  std::size_t standing = 300;  ///< points, at least
  double overlap = 0.4;  ///< share of the standing points that lie on the other one's surfaces,
                         ///< and of those of floors and ceilings
  double contradicted = 0.03;  ///< of those that the other one can tell about, at most
  double missing = 1.0;        ///< of those in free sight of the other one, at most, if partial
  double beside = 1.0;         ///< of the query's walls, beside the place's, at most, if partial
  double gap_metres = 0.1;     ///< between registrations
  double gap_degrees = 1.0;
  int agreeing = 3;  ///< registrations, of both directions
  double bend = kMostBent;
  /// The query shows a part of the place alone, what was seen in a second: it has to lie on the
  /// place, and the place need not be all in it. What else would stand there free space tells.
  bool partial = false;
};

/// What was asked of two submaps, and the answers.
struct LoopCheck {
  LoopVerdict verdict = LoopVerdict::little_to_see;
  SubmapAlignment alignment;  ///< of the query in the place's frame
  double overlap = 0.0;       ///< the smaller one of both directions
  double level = 0.0;         ///< the same of what lies
  double contradicted = 0.0;  ///< the larger one
  double missing = 0.0;       ///< the larger one; of a partial query alone
  double beside = 0.0;        ///< of the query's walls: beside_walls(); likewise
  double bend = 0.0;          ///< of both together: standard deviation, kLever away [m]
  int agreeing = 0;           ///< registrations that ended at the same pose
  int started = 0;
};

/// Share of the standing points of one that stand where the other saw nothing, of those that it can
/// tell about; the larger one of both directions. 1 where it can tell about none.
[[nodiscard]] double contradiction_between(const VerifiableSubmap& one,
                                           const VerifiableSubmap& other, const Pose& T_one_other);

/// Share of the planes' points of one that stand in free sight of the other and are not seen there;
/// the larger one of both directions. What is too little to tell counts as none.
[[nodiscard]] double missing_between(const VerifiableSubmap& one, const VerifiableSubmap& other,
                                     const Pose& T_one_other);

/// `starts`: T_place_query, several; none: the odometry leaves none open.
[[nodiscard]] LoopCheck check_places(const VerifiableSubmap& place, const VerifiableSubmap& query,
                                     const std::vector<Pose>& starts, const LoopLimits& limits);

}  // namespace surefoot::mapping
