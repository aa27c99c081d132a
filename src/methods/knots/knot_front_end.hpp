// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "core/front_end.hpp"
#include "methods/knots/dependence.hpp"
#include "methods/knots/evidence.hpp"
#include "methods/knots/growing_map.hpp"
#include "methods/knots/held_back.hpp"
#include "methods/knots/knot_attempts.hpp"
#include "methods/knots/knot_prediction.hpp"
#include "methods/knots/knot_search.hpp"
#include "methods/knots/place_trials.hpp"
#include "methods/knots/sweep_bend.hpp"
#include "methods/knots/velocity_model.hpp"
#include "methods/knots/walked_way.hpp"

namespace surefoot {

/// Surefoot's own method: the poses within the scan are estimated, not predicted. docs/method.md.
class KnotFrontEnd : public FrontEnd {
 public:
  explicit KnotFrontEnd(const Session& session);

  Estimate add(const PreparedScan& scan) override;

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

  struct FirstScan {
    PreparedScan scan;
    std::vector<std::uint32_t> thinned;
  };

  /// A scan's registration.
  struct Registered {
    KnotEnd begin;
    KnotWindow predicted;
    KnotRegistration found{};
    KnotWindow bent{};  // as registered, in a map that may be bent
    ScanTrajectory trajectory{};
    ScanTrajectory told{};  // let go of; the map and what is expected next do not rely on it
    Estimate estimate{};
    Signs signs{};
    double deviation = 0.0;  // [m] of the worst held position, with what all scans err by alike
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
  };

  [[nodiscard]] Pose beginning_pose(const PreparedScan& scan);
  Estimate begin_map(const PreparedScan& scan, const std::vector<std::uint32_t>& thinned);
  [[nodiscard]] KnotProblem problem(const KnotEnd& begin) const;
  [[nodiscard]] Registered register_next(const PreparedScan& scan,
                                         const std::vector<std::uint32_t>& thinned);
  [[nodiscard]] Registered register_scan(const PreparedScan& scan,
                                         const std::vector<std::uint32_t>& thinned,
                                         const KnotEnd& begin);
  void conclude(const PreparedScan& scan, std::size_t points, Registered& registered) const;
  void tell(Registered& registered) const;
  void judge(const PreparedScan& scan, const View& view, Registered& registered) const;
  [[nodiscard]] double hazard_of(const PreparedScan& scan,
                                 const std::vector<std::uint32_t>& thinned, const View& view,
                                 Registered& registered) const;
  [[nodiscard]] double objection_of(const Estimate& estimate, double hazard_now) const;
  [[nodiscard]] bool is_lost(double objection, double of_all) const;
  [[nodiscard]] double since_trusted(std::int64_t instant_ns) const;
  [[nodiscard]] bool is_after_hole(const PreparedScan& scan) const;
  [[nodiscard]] bool is_farther_back(const Pose& place, const PreparedScan& scan) const;
  [[nodiscard]] static bool sees_more_new(double at_one, double at_other);
  [[nodiscard]] double mean_speed() const;
  Estimate accept(double hazard_now, View view, Registered registered);
  Estimate lose(const PreparedScan& scan, const std::vector<std::uint32_t>& thinned,
                Registered registered);
  /// Whether the scan can tell where it was taken: it was not seen before, and is not reversed.
  [[nodiscard]] bool can_be_placed() const { return !seen_again_ && !reversed_; }
  Estimate search(const PreparedScan& scan, const std::vector<std::uint32_t>& thinned);
  [[nodiscard]] std::optional<Registered> register_lost(const PreparedScan& scan,
                                                        const std::vector<std::uint32_t>& thinned);
  Estimate stay_lost(const PreparedScan& scan, const std::vector<std::uint32_t>& thinned);
  [[nodiscard]] bool may_be_a_storey_on(std::int64_t instant_ns) const;
  [[nodiscard]] SearchRegion region_within(double speed, std::int64_t instant_ns) const;
  [[nodiscard]] SearchRegion region_walked(std::int64_t instant_ns) const;
  [[nodiscard]] SearchRegion region_carried(std::int64_t instant_ns) const;
  [[nodiscard]] SearchRegion region_anywhere() const;
  [[nodiscard]] SearchRegion straight_on(std::int64_t instant_ns) const;
  [[nodiscard]] std::optional<SearchRegion> region_of_turn(std::int64_t instant_ns) const;
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
  [[nodiscard]] std::optional<Registered> register_ahead(const PreparedScan& scan,
                                                         const std::vector<std::uint32_t>& thinned);
  [[nodiscard]] std::optional<Registered> find_place(const PreparedScan& scan,
                                                     const std::vector<std::uint32_t>& thinned,
                                                     const SearchRegion& region);
  [[nodiscard]] bool has_twin(const PreparedScan& scan, const std::vector<std::uint32_t>& thinned,
                              const Registered& registered) const;
  [[nodiscard]] double disagreement_of(const Registered& registered) const;
  [[nodiscard]] std::optional<Estimate> go_on(const PreparedScan& scan,
                                              const std::vector<std::uint32_t>& thinned);
  [[nodiscard]] double rival_in(const SearchRegion& region, std::size_t most,
                                const PreparedScan& scan, const std::vector<std::uint32_t>& thinned,
                                const Registered& registered) const;
  [[nodiscard]] double rival_beside(const PreparedScan& scan,
                                    const std::vector<std::uint32_t>& thinned,
                                    const Registered& registered) const;
  [[nodiscard]] double rival_anywhere(const PreparedScan& scan,
                                      const std::vector<std::uint32_t>& thinned,
                                      const Registered& registered) const;
  void learn(const Registered& registered, double right);
  [[nodiscard]] Twist let_go(const Twist& held_back, const Eigen::Quaterniond& rotation) const;
  void let_drift(Registered& registered);
  [[nodiscard]] Twist first_velocity(const PreparedScan& scan,
                                     const std::vector<std::uint32_t>& thinned);
  [[nodiscard]] Beginning beginning_at(const Twist& velocity) const;
  [[nodiscard]] Registered register_second(const PreparedScan& scan,
                                           const std::vector<std::uint32_t>& thinned);
  [[nodiscard]] bool is_better(const Registered& one, const Registered& other,
                               double times_less) const;
  [[nodiscard]] Beginning registered_on(Beginning beginning, int rounds, const PreparedScan& scan,
                                        const std::vector<std::uint32_t>& thinned);
  [[nodiscard]] std::optional<Beginning> turned(const Beginning& beginning,
                                                const PreparedScan& scan,
                                                const std::vector<std::uint32_t>& thinned);
  void take(const Beginning& beginning);
  void clear_map();
  void forget_verdicts();
  [[nodiscard]] View look(const PreparedScan& scan, const std::vector<std::uint32_t>& thinned,
                          const ScanTrajectory& trajectory);
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
  Dependence dependence_;
  HeldBack held_back_{HeldBack::Mean::left_out};
  HeldBack held_back_in_all_{HeldBack::Mean::counted};
  UsualSigns usual_signs_;
  Verdict verdict_;
  Verdict objections_;            // of the same scans, what speaks for leaving the map
  std::uint64_t last_print_ = 0;  // of the last scan's points
  bool seen_again_ = false;       // this scan's are the same
  Eigen::Vector3f sweep_axis_ = Eigen::Vector3f::Zero();  // of the map's first scan
  bool reversed_ = false;                                 // this scan's beams turn the other way
  std::optional<FirstScan> first_scan_;                   // until its motion is known
  LevelReport level_;
  // The last scan. Few of its points are needed here, all of them only by who asks.
  mutable ToDeskew to_deskew_;
  mutable DeskewedScan last_scan_;
  std::int64_t held_ns_ = 0;  // when a scan last held all directions
  int agreed_ = 0;            // trusted scans of this map
  int lost_in_a_row_ = 0;     // scans that could not be registered
  std::optional<PoseSearch> search_;
  int segment_ = 0;  // how often the map began anew
};

}  // namespace surefoot
