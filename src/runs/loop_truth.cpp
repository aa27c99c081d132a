// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/loop_truth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "evaluation/association.hpp"
#include "io/recording.hpp"
#include "io/trajectory_files.hpp"
#include "runs/run_truth.hpp"

namespace surefoot::runs {

namespace {

constexpr double kRevisit = 3.0;  // [m]

// [ns] Between these a robot moves evenly; a truth may be much finer, and as large as all else.
constexpr std::int64_t kTruthStep = 10'000'000;

/// True poses of the pieces' frames.
std::vector<Pose> true_pieces(const std::vector<mapping::Piece>& pieces, const Trajectory& truth) {
  Trajectory wanted;
  for (const mapping::Piece& piece : pieces) wanted.push_back({piece.stamp_ns, {}});
  evaluation::AssociationOptions options;
  options.method = evaluation::AssociationMethod::interpolate;
  const Trajectory found = evaluation::associate(truth, wanted, options).reference;
  if (found.size() != pieces.size()) {
    throw std::runtime_error("the truth does not reach over all of the recording");
  }
  std::vector<Pose> result;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    result.push_back(found[i].pose * pieces[i].T_piece_lidar.inverse());
  }
  return result;
}

}  // namespace

Trajectory truth_of_loops(const RunOptions& options,
                          const std::function<void(const std::string& text)>& say) {
  const std::filesystem::path beside = truth_beside(options.input);
  try {
    if (!options.truth.empty()) return read_truth_poses(options.truth);
    return beside.empty() ? Trajectory{} : io::read_tum_thinned(beside, kTruthStep);
  } catch (const io::ReadError& error) {
    say(fmt::format("loops are not judged: {}", error.what()));
    return {};
  }
}

LoopScore LoopTruth::score() const {
  return {static_cast<std::size_t>(std::count(revisits.begin(), revisits.end(), true)),
          static_cast<std::size_t>(std::count(found.begin(), found.end(), true)), taken_false};
}

LoopTruth judge_loops(const mapping::WalkMapper& mapper, const Trajectory& truth,
                      double way_between) {
  LoopTruth result;
  const std::vector<mapping::Piece>& pieces = mapper.pieces();
  if (pieces.empty()) return result;
  const std::vector<Pose> poses = true_pieces(pieces, truth);
  std::vector<bool> closed(pieces.size(), false);
  for (const mapping::Loop& loop : mapper.loops()) {
    const Pose motion = poses[loop.place].inverse() * poses[loop.query];
    const mapping::AlignmentGap gap = mapping::gap_between(loop.check.alignment, motion);
    result.errors.push_back({gap.metres, gap.degrees});
    if (loop.check.verdict != mapping::LoopVerdict::taken) continue;
    ++result.taken;
    result.taken_false += result.errors.back().right() ? 0 : 1;
    closed[loop.query] = true;
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    bool revisit = false;
    for (std::size_t k = 0; k < i && !revisit; ++k) {
      const Eigen::Vector3d apart = poses[i].translation - poses[k].translation;
      revisit = pieces[i].way - pieces[k].way >= way_between && apart.norm() < kRevisit &&
                std::abs(apart.z()) < mapping::kHalfStorey;
    }
    result.revisits.push_back(revisit);
    const bool found =
        closed[i] || (i > 0 && closed[i - 1]) || (i + 1 < closed.size() && closed[i + 1]);
    result.found.push_back(revisit && found);
  }
  return result;
}

}  // namespace surefoot::runs
