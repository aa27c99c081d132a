// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "core/front_end.hpp"
#include "methods/knots/knot_beginning.hpp"
#include "methods/knots/knot_track.hpp"
#include "methods/knots/scan_judge.hpp"
#include "methods/knots/sweep_axis.hpp"

namespace surefoot {

/// Surefoot's own method in one map: the poses within the scan are estimated, not predicted. It
/// begins the map, follows who walks in it, and looks for him where he is lost. docs/method.md.
class KnotFrontEnd : public FrontEnd {
 public:
  explicit KnotFrontEnd(const Session& session);

  /// One that is lost, and goes on in a map of its own: what was learnt that is not of a map, and
  /// the last pose, are another one's. `segments`: that there were.
  KnotFrontEnd(const KnotFrontEnd& lost, int segments);

  Estimate add(const PreparedScan& scan) override;

  /// Whether it has searched for itself in vain by now, and a map should begin anew: the last scan
  /// is lost, and so is the next one.
  [[nodiscard]] bool is_in_vain() const { return in_vain_; }
  /// Whether its map is worth to come back to: of scans enough to be believed, and none that is
  /// left for the storey above.
  [[nodiscard]] bool is_worth_keeping(std::int64_t instant_ns) const;
  /// Trusted scans of its map.
  [[nodiscard]] int agreed() const { return track_.agreed(); }
  /// From now on it is elsewhere: a scan is looked for along the whole way, or is lost.
  void leave();
  /// Whether the last scan was found, and the next one is to confirm that.
  [[nodiscard]] bool is_confirming() const { return search_ && search_->found; }

  [[nodiscard]] std::optional<StampedPose> last_pose() const override { return last_told_; }
  [[nodiscard]] Twist velocity() const override { return track_.velocity(); }
  [[nodiscard]] const LevelReport& level() const override { return level_; }
  [[nodiscard]] const DeskewedScan& deskewed_scan() const override;
  [[nodiscard]] std::vector<Eigen::Vector3d> local_map() const override {
    return track_.map().surfels().points();
  }
  [[nodiscard]] Cubes emptied_cubes() const override { return track_.map().emptied(); }

 private:
  /// A scan that can be deskewed when that is asked for; null once it is.
  struct ToDeskew {
    const PreparedScan* scan = nullptr;
    ScanTrajectory trajectory;
  };
  /// Since it is lost.
  struct PoseSearch {
    int scans = 0;
    std::optional<KnotEnd> found;  // where it may be: to be confirmed
    double rival = 0.0;            // Evidence's, of that place
    bool has_twin = false;         // the last one that was confirmed looks as another does
    bool far = false;              // that was looked for in a large region
    int agreed = 0;                // scans that say so
    int needed = kAgree;           // of these
    bool left = false;             // it went on in another map
  };

  /// Who was found, and not lost again for so many trusted scans, is right there.
  static constexpr int kSettled = 10;

  Pose begin_level(const PreparedScan& scan);
  Estimate begin_map(const ScanPart& thinned);
  Estimate follow(const ScanPart& thinned);
  Estimate accept(const PreparedScan& scan, double hazard_now, View view,
                  RegisteredScan registered);
  Estimate lose(const ScanPart& thinned, RegisteredScan registered);
  /// Whether the scan can tell where it was taken: it was not seen before, and is not reversed.
  [[nodiscard]] bool can_be_placed() const { return !seen_again_ && !reversed_; }
  void begin_search();
  void end_search();
  Estimate search(const ScanPart& thinned);
  [[nodiscard]] std::optional<Estimate> go_on(const ScanPart& thinned);
  [[nodiscard]] std::optional<RegisteredScan> register_lost(const ScanPart& thinned);
  Estimate stay_lost(const PreparedScan& scan);
  [[nodiscard]] Estimate publish(const PreparedScan& scan, const ScanTrajectory& trajectory,
                                 Estimate estimate);

  const Session& session_;
  const Config& config_;

  // Everything that outlives a scan.
  KnotTrack track_;
  ScanJudge judge_;
  std::optional<KnotBeginning> beginning_;  // until the first scan's motion is known
  std::optional<PoseSearch> search_;
  int lost_in_a_row_ = 0;  // scans that could not be registered
  int relapses_ = 0;       // how often, one soon after the other, it was lost where it was found
  int since_found_ = kSettled;  // trusted scans, up to this
  bool in_vain_ = false;
  int segment_ = 0;  // how often the map began anew
  LevelReport level_;
  bool is_levelled_ = false;  // the map's z axis is up: a ground was seen, or who runs it says so
  PointChoice map_choice_;
  std::uint64_t last_print_ = 0;  // of the last scan's points
  bool seen_again_ = false;       // this scan's are the same
  SweepDirection sweep_direction_;
  bool reversed_ = false;                 // this scan's beams turn the other way
  std::optional<StampedPose> last_told_;  // trusted, let go of
  // The last scan. Few of its points are needed here, all of them only by who asks.
  mutable ToDeskew to_deskew_;
  mutable DeskewedScan last_scan_;
};

}  // namespace surefoot
