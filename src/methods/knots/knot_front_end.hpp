// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "core/front_end.hpp"
#include "methods/knots/error_model.hpp"
#include "methods/knots/evidence.hpp"
#include "methods/knots/growing_map.hpp"
#include "methods/knots/knot_attempts.hpp"
#include "methods/knots/knot_prediction.hpp"
#include "methods/knots/knot_search.hpp"
#include "methods/knots/place_trials.hpp"
#include "methods/knots/sweep_axis.hpp"
#include "methods/knots/sweep_bend.hpp"
#include "methods/knots/velocity_model.hpp"
#include "methods/knots/walked_way.hpp"
#include "methods/knots/whereabouts.hpp"

namespace surefoot {

/// Surefoot's own method: the poses within the scan are estimated, not predicted. docs/method.md.
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
  [[nodiscard]] int agreed() const { return agreed_; }
  /// From now on it is elsewhere: a scan is looked for along the whole way, or is lost.
  void leave();
  /// Whether the last scan was found, and the next one is to confirm that.
  [[nodiscard]] bool is_confirming() const { return search_ && search_->found; }

  [[nodiscard]] std::optional<StampedPose> last_pose() const override { return last_told_; }
  [[nodiscard]] Twist velocity() const override { return velocity_; }
  [[nodiscard]] const LevelReport& level() const override { return level_; }
  [[nodiscard]] const DeskewedScan& deskewed_scan() const override;
  [[nodiscard]] std::vector<Eigen::Vector3d> local_map() const override {
    return map_.surfels().points();
  }
  [[nodiscard]] Cubes emptied_cubes() const override { return map_.emptied(); }

 private:
  /// So many scans must agree before a map, or a place that was found again, is believed.
  static constexpr int kAgree = 3;

  /// A scan and the points of it that are for the map; those that are registered are some of them.
  struct ScanPart {
    const PreparedScan& scan;
    const std::vector<std::uint32_t>& points;
  };
  /// The same, kept.
  struct FirstScan {
    PreparedScan scan;
    std::vector<std::uint32_t> points;

    [[nodiscard]] ScanPart thinned() const { return {scan, points}; }
  };

  /// A scan's registration.
  struct Registered {
    KnotEnd begin;
    KnotWindow predicted;
    KnotRegistration found{};
    KnotWindow bent{};  // as registered, in a map that may be bent
    ScanTrajectory trajectory{};
    ToldScan told{};
    Estimate estimate{};
    Signs signs{};
  };
  /// How a map's first scan moved, and the second one's registration on a map of that.
  struct Beginning {
    ScanTrajectory first;
    KnotEnd end;  // of the first
    VelocityModel model;
    Registered second;
  };
  /// A scan that can be deskewed when that is asked for; null once it is.
  struct ToDeskew {
    const PreparedScan* scan = nullptr;
    ScanTrajectory trajectory;
  };
  /// Since it is lost.
  struct PoseSearch {
    int scans = 0;
    std::optional<KnotEnd> found;  // where it may be: to be confirmed
    bool far = false;              // that was looked for in a large region
    int agreed = 0;                // scans that say so
    bool after_hole = false;       // it may have walked on, unseen
    bool left = false;             // it went on in another map
  };

  [[nodiscard]] Pose beginning_pose(const PreparedScan& scan);
  Estimate begin_map(const ScanPart& thinned);
  [[nodiscard]] std::vector<std::uint32_t> choose(const ScanPart& thinned);
  [[nodiscard]] std::vector<std::uint32_t> chosen_in_passing(const ScanPart& thinned) const;
  [[nodiscard]] KnotProblem problem(const KnotEnd& begin) const;
  [[nodiscard]] Registered register_next(const ScanPart& thinned);
  [[nodiscard]] Registered register_scan(const ScanPart& thinned, const KnotEnd& begin);
  void conclude(const PreparedScan& scan, std::size_t points, Registered& registered) const;
  void judge(const PreparedScan& scan, const View& view, Registered& registered) const;
  [[nodiscard]] double hazard_of(const ScanPart& thinned, const View& view,
                                 Registered& registered) const;
  [[nodiscard]] double objection_of(const Estimate& estimate, double hazard_now) const;
  [[nodiscard]] bool is_lost(double objection, double of_all) const;
  [[nodiscard]] Whereabouts whereabouts() const;
  [[nodiscard]] static bool sees_more_new(double at_one, double at_other);
  Estimate accept(double hazard_now, View view, Registered registered);
  Estimate lose(const ScanPart& thinned, Registered registered);
  /// Whether the scan can tell where it was taken: it was not seen before, and is not reversed.
  [[nodiscard]] bool can_be_placed() const { return !seen_again_ && !reversed_; }
  Estimate search(const ScanPart& thinned);
  [[nodiscard]] std::optional<Registered> register_lost(const ScanPart& thinned);
  Estimate stay_lost(const ScanPart& thinned);
  [[nodiscard]] std::vector<PlaceFit> places_in(const PreparedScan& scan,
                                                const std::vector<std::uint32_t>& chosen,
                                                const SearchRegion& region, std::size_t most) const;
  [[nodiscard]] std::vector<PlaceStart> starts_at(const std::vector<PlaceFit>& places) const;
  [[nodiscard]] std::optional<Registered> register_from(
      const KnotEnd& begin, const KnotWindow& predicted, const KnotWindow& start,
      const PreparedScan& scan, const std::vector<std::uint32_t>& chosen) const;
  [[nodiscard]] std::optional<Registered> register_at(
      const PlaceStart& start, const PreparedScan& scan,
      const std::vector<std::uint32_t>& chosen) const;
  [[nodiscard]] std::optional<Registered> register_ahead(const ScanPart& thinned);
  [[nodiscard]] std::optional<Registered> find_place(const ScanPart& thinned,
                                                     const SearchRegion& region);
  [[nodiscard]] bool has_twin(const ScanPart& thinned, const Registered& registered) const;
  [[nodiscard]] double disagreement_of(const Registered& registered) const;
  [[nodiscard]] std::optional<Estimate> go_on(const ScanPart& thinned);
  [[nodiscard]] double rival_in(const SearchRegion& region, std::size_t most,
                                const ScanPart& thinned, const Registered& registered) const;
  [[nodiscard]] double rival_beside(const ScanPart& thinned, const Registered& registered) const;
  [[nodiscard]] double rival_anywhere(const ScanPart& thinned, const Registered& registered) const;
  void learn(const Registered& registered, double right);
  void let_drift(Registered& registered);
  void name_weakness_of_late(Registered& registered);
  [[nodiscard]] Twist first_velocity(const ScanPart& thinned);
  [[nodiscard]] Beginning beginning_at(const Twist& velocity) const;
  [[nodiscard]] Registered register_second(const ScanPart& thinned);
  [[nodiscard]] bool is_better(const Registered& one, const Registered& other,
                               double times_less) const;
  [[nodiscard]] Beginning registered_on(Beginning beginning, int rounds, const ScanPart& thinned);
  [[nodiscard]] std::optional<Beginning> turned(const Beginning& beginning,
                                                const ScanPart& thinned);
  void take(const Beginning& beginning);
  void clear_map();
  void forget_verdicts();
  [[nodiscard]] View look(const ScanPart& thinned, const ScanTrajectory& trajectory);
  void integrate(View view);
  [[nodiscard]] KnotEnd end_of(const KnotWindow& window, const Matrix12& information) const;
  void finish(const KnotWindow& window, const Matrix12& information);
  [[nodiscard]] Estimate publish(const ScanTrajectory& trajectory, Estimate estimate);

  const Session& session_;
  const Config& config_;

  // Everything that outlives a scan.
  GrowingMap map_;
  WalkedWay way_;  // within its reach
  VelocityModel model_;
  SweepBend bend_;  // of the map
  PointChoice map_choice_;
  PointChoice choice_;
  KnotEnd end_;
  std::optional<StampedPose> last_pose_;  // trusted, in the map
  std::optional<StampedPose> last_told_;  // the same, let go of
  Twist velocity_ = Twist::Zero();
  UsualFit usual_;
  ErrorModel errors_;
  UsualSigns usual_signs_;
  Verdict verdict_;
  Verdict objections_;            // of the same scans, what speaks for leaving the map
  std::uint64_t last_print_ = 0;  // of the last scan's points
  bool seen_again_ = false;       // this scan's are the same
  SweepDirection sweep_direction_;
  bool reversed_ = false;                // this scan's beams turn the other way
  std::optional<FirstScan> first_scan_;  // until its motion is known
  LevelReport level_;
  // The last scan. Few of its points are needed here, all of them only by who asks.
  mutable ToDeskew to_deskew_;
  mutable DeskewedScan last_scan_;
  std::int64_t held_ns_ = 0;  // when a scan last held all directions
  int agreed_ = 0;            // trusted scans of this map
  int lost_in_a_row_ = 0;     // scans that could not be registered
  std::optional<PoseSearch> search_;
  bool in_vain_ = false;
  Eigen::Quaterniond mount_ = Eigen::Quaterniond::Identity();  // R_lidar_carrier
  std::vector<DegenerateDirection> weak_of_late_;              // of the last scan that had any
  int segment_ = 0;                                            // how often the map began anew
};

}  // namespace surefoot
