// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/front_end.hpp"
#include "methods/knots/error_model.hpp"
#include "methods/knots/evidence.hpp"
#include "methods/knots/growing_map.hpp"
#include "methods/knots/knot_attempts.hpp"
#include "methods/knots/knot_prediction.hpp"
#include "methods/knots/place_trials.hpp"
#include "methods/knots/sweep_bend.hpp"
#include "methods/knots/velocity_model.hpp"
#include "methods/knots/walked_way.hpp"
#include "methods/knots/whereabouts.hpp"

namespace surefoot {

/// A scan and the points of it that are for the map; those that are registered are some of them.
struct ScanPart {
  const PreparedScan& scan;
  const std::vector<std::uint32_t>& points;
};

/// A scan's registration, and what is told of it.
struct RegisteredScan {
  KnotEnd begin;  ///< where the scan was taken to begin
  KnotWindow predicted;
  KnotRegistration found{};     ///< its window as `bent`, straightened
  KnotWindow bent{};            ///< as registered, in a map that may be bent
  ScanTrajectory trajectory{};  ///< the found window's, over the scan
  ToldScan told{};              ///< if the estimate is trusted
  Estimate estimate{};          ///< its evidence and probability by ScanJudge
  Signs signs{};                ///< likewise
};

/// A map and who walks in it: where the last scan ended, how the sensor moves, with what its
/// registrations usually end. Registers scans, and learns from those that are taken for right;
/// which these are is for others to say (ScanJudge).
class KnotTrack {
 public:
  /// A map of no scan. `session` outlives it.
  explicit KnotTrack(const Session& session);
  /// What one learnt who got lost in another map, as far as it is not of that map.
  void take_over(const KnotTrack& lost);

  /// The map begins with a scan, at rest. It is levelled if its z axis is known to be up.
  void begin(const ScanPart& first, const Pose& T_map_lidar, bool is_levelled);
  /// Takes a registration for right: learns from it, and maps what the scan saw.
  /// @param right how probably it is
  void accept(const RegisteredScan& registered, double right, View view);
  /// The scan was not registered: the next one begins where this one was predicted to end.
  void miss(const RegisteredScan& registered);
  /// Whether it was lost in a hole of the recording, in which it may have walked on.
  void may_have_walked_unseen(bool may) { walked_unseen_ = may; }

  /// A scan from where the last one ended; after a short hole also where it would be had it walked
  /// on.
  [[nodiscard]] RegisteredScan register_next(const ScanPart& thinned);
  /// A scan from where it is taken to begin.
  [[nodiscard]] RegisteredScan register_scan(const ScanPart& thinned, const KnotEnd& begin);
  /// Likewise, of these points and from some motion; none if that is not solved.
  [[nodiscard]] std::optional<RegisteredScan> register_from(
      const KnotEnd& begin, const KnotWindow& predicted, const KnotWindow& start,
      const PreparedScan& scan, const std::vector<std::uint32_t>& chosen) const;

  /// The points of a scan to register; the next scan's depend on it.
  [[nodiscard]] std::vector<std::uint32_t> choose(const ScanPart& thinned);
  /// Likewise, but that they do not.
  [[nodiscard]] std::vector<std::uint32_t> chosen_in_passing(const ScanPart& thinned) const;
  /// What a scan saw, deskewed, in the map's frame.
  [[nodiscard]] View look(const ScanPart& thinned, const ScanTrajectory& trajectory) const;
  [[nodiscard]] KnotProblem problem(const KnotEnd& begin) const;
  [[nodiscard]] double disagreement_of(const RegisteredScan& registered) const;
  /// Where the scan after a registered one begins; not all that is known of it is relied on.
  [[nodiscard]] KnotEnd end_of(const RegisteredScan& registered) const;
  /// Of the last trusted scan; what it refers to changes with this.
  [[nodiscard]] Whereabouts whereabouts() const;

  /// Another way in which the map began: where its first scan ended, how it moved, what it saw.
  void begin_otherwise(const KnotEnd& end, const VelocityModel& model, View first);
  /// The map of one scan alone.
  void map_alone(View view);
  /// Nothing was emptied since the last scan; waits until that one is in the map.
  void forget_emptied() { map_.forget_emptied(); }

  [[nodiscard]] const Session& session() const { return session_; }
  [[nodiscard]] const Config& config() const { return session_.config; }
  [[nodiscard]] const GrowingMap& map() const { return map_; }
  [[nodiscard]] const WalkedWay& way() const { return way_; }
  [[nodiscard]] const VelocityModel& model() const { return model_; }
  [[nodiscard]] const KnotEnd& end() const { return end_; }
  /// The last trusted pose, as it is mapped; none before the first map.
  [[nodiscard]] const std::optional<StampedPose>& last_pose() const { return last_pose_; }
  [[nodiscard]] const Eigen::Quaterniond& mount() const { return mount_; }
  /// As Estimate::twist.
  [[nodiscard]] const Twist& velocity() const { return velocity_; }
  /// Trusted scans of the map.
  [[nodiscard]] int agreed() const { return agreed_; }

 private:
  [[nodiscard]] std::optional<RegisteredScan> register_at(
      const PlaceStart& start, const PreparedScan& scan,
      const std::vector<std::uint32_t>& chosen) const;
  [[nodiscard]] std::optional<RegisteredScan> register_ahead(const ScanPart& thinned);
  void conclude(const PreparedScan& scan, std::size_t points, RegisteredScan& registered) const;
  [[nodiscard]] KnotEnd end_of(const KnotWindow& window, const Matrix12& information) const;
  void finish(const KnotWindow& window, const Matrix12& information);
  void integrate(View view);

  const Session& session_;
  GrowingMap map_;
  WalkedWay way_;  // within the map's reach
  VelocityModel model_;
  SweepBend bend_;  // of the map
  PointChoice choice_;
  KnotEnd end_;
  std::optional<StampedPose> last_pose_;
  std::int64_t last_end_ns_ = 0;  // of its scan
  bool walked_unseen_ = false;
  Twist velocity_ = Twist::Zero();
  UsualFit usual_;
  ErrorModel errors_;
  Eigen::Quaterniond mount_ = Eigen::Quaterniond::Identity();  // R_lidar_carrier
  int agreed_ = 0;
};

}  // namespace surefoot
