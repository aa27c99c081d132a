// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// All figures about one estimate at once.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "evaluation/alignment.hpp"
#include "evaluation/association.hpp"
#include "evaluation/drift.hpp"
#include "evaluation/rpe.hpp"
#include "evaluation/segments.hpp"
#include "evaluation/statistics.hpp"

namespace surefoot::evaluation {

struct EvaluationOptions {
  AssociationOptions association = {};
  AlignmentMethod alignment = AlignmentMethod::rigid;
  std::size_t alignment_poses = 0;           ///< pairs from the start that are aligned; 0: all
  PairOptions stretches = {};                ///< of the relative pose error
  bool stretches_from_reference = false;     ///< measured along the reference, not the estimate
  std::vector<double> segment_lengths = {};  ///< [m]; empty: by the length of the reference
  /// The reference has no rotations, as a prism's has none: errors that need them are left out.
  bool positions_only = false;
  std::int64_t usual_step_ns = 0;  ///< between an estimate's poses where none is missing; 0: median
};

/// One kind of error with its statistics.
struct NamedStatistics {
  std::string name;  ///< such as "ape_translation"
  std::string unit;  ///< "m", "deg", "%" or empty for a norm
  Statistics statistics;
};

struct Evaluation {
  std::string name;            ///< of the estimate
  std::size_t pairs = 0;       ///< poses that found a partner
  std::size_t poses = 0;       ///< of the estimate
  std::size_t most_pairs = 0;  ///< that there could be in the time that both trajectories have
  double coverage = 0.0;       ///< share [0, 1] of the reference that has an estimate
  TrajectoryAlignment alignment;
  std::vector<NamedStatistics> absolute;
  std::vector<NamedStatistics> relative;  ///< empty if the run is too short for one stretch
  SegmentErrors segments;
  EndDrift drift;
};

/// One kind of error by its name; nullptr if the evaluation has none.
[[nodiscard]] const Statistics* find_statistics(const Evaluation& evaluation,
                                                std::string_view name);

/// Throws what associate(), find_alignment(), find_pairs() and segment_errors() throw.
[[nodiscard]] Evaluation evaluate(const std::string& name, const Trajectory& reference,
                                  const Trajectory& estimate, const EvaluationOptions& options);

}  // namespace surefoot::evaluation
