// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Where in a saved map the robot is, from an unknown start, by its LiDAR alone. "Not found yet" is
// an answer; a wrong place is none.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mapping/loop_verifier.hpp"
#include "mapping/map_file.hpp"
#include "mapping/place_agreement.hpp"
#include "mapping/place_choice.hpp"
#include "mapping/place_index.hpp"

namespace surefoot::mapping {

/// What is asked of what was seen in a second or two. What else speaks against a place is weighed:
/// fit_of().
[[nodiscard]] inline LoopLimits part_of_a_place() {
  LoopLimits limits;
  limits.partial = true;
  limits.overlap = 0.4;
  limits.contradicted = 1.0;
  limits.agreeing = 1;  // of three starts: those that end elsewhere fit clearly worse
  limits.bend = 0.13;   // of scans that the odometry was sure of: see collect()
  return limits;
}

/// Under a roof storeys, halls and stairs repeat themselves: there it has to be what a loop is.
[[nodiscard]] inline LoopLimits part_of_a_roofed_place() {
  LoopLimits limits;
  limits.partial = true;
  limits.overlap = 0.65;
  limits.missing = 0.1;  // of a car park: cars
  limits.beside = 0.15;
  limits.bend = 0.1;
  return limits;
}

/// And clearly so: of a wrong storey 0.97 fitted, and 0.69 of the right one, which was mapped
/// badly; so no other may pass.
[[nodiscard]] inline ChoiceLimits roofed_choice() {
  ChoiceLimits limits;
  limits.fit = 0.6;
  limits.clearly = 0.3;
  limits.alone = true;
  return limits;
}

/// Pieces of which fewer scans are enough.
[[nodiscard]] inline PieceOptions sparse_pieces() {
  PieceOptions pieces;
  pieces.step = 0.5;
  return pieces;
}

struct LocalizerOptions {
  PieceOptions pieces = sparse_pieces();
  LoopLimits limits = part_of_a_place();
  AgreementLimits agreement;
  ChoiceLimits choice;
  LoopLimits roofed_limits = part_of_a_roofed_place();
  ChoiceLimits roofed_choice = mapping::roofed_choice();
  std::size_t candidates = 6;    ///< places that are verified in a search
  std::size_t every = 3;         ///< scans between two searches
  double check_every = 8.0;      ///< of way, once the place is known [m];
  double check_again = 2.0;      ///< where the last look did not confirm it
  double look_back = 3.0;        ///< of way that a check looks at [m]; more is not collected for it
  double confirming = 0.4;       ///< share of what stands that lies on the map, while it is known
  double missing_at_most = 0.1;  ///< and of what would be in free sight
  double lost_after = 12.0;      ///< of way on which no check succeeded [m]
};

class MapLocalizer {
 public:
  /// The map's pieces stand at their corrected poses.
  MapLocalizer(SavedMap map, const LocalizerOptions& options);

  /// A scan that was registered by the odometry, in the order in which they come.
  void add(const PlacedScan& scan, const ScanPoints& points);
  void add(const PlacedScan& scan, const DeskewedScan& points) { add(scan, ready(points)); }

  /// T_map_world, from the odometry's world to the map; none: not found yet, or lost.
  [[nodiscard]] const std::optional<Pose>& T_map_world() const { return T_map_world_; }
  /// One sentence about the last search or check.
  [[nodiscard]] const std::string& message() const { return message_; }

 private:
  /// What was seen on the last metres, in the frame of the piece that is being walked.
  struct Surroundings {
    VerifiableSubmap seen;
    Pose T_world_seen;
  };

  /// The one place that passed every question.
  struct OnlyPlace {
    Pose T_map_world;
    double fit = 0.0;
    std::size_t frame = 0;
  };
  struct Answer {
    std::optional<OnlyPlace> place;
    bool several = false;
  };

  [[nodiscard]] double to_check() const;
  void collect(const PlacedScan& scan, const ScanPoints& points);
  void forget();
  [[nodiscard]] std::optional<Surroundings> surroundings() const;
  void search();
  void forget_places();
  void check();
  [[nodiscard]] std::optional<Pose> confirmed();
  [[nodiscard]] std::optional<std::size_t> nearest_place(const Eigen::Vector3d& at,
                                                         std::size_t frame) const;
  [[nodiscard]] std::shared_ptr<const VerifiableSubmap> submap_of(std::size_t place);
  [[nodiscard]] AskedPlace ask_place(std::size_t number, const Surroundings& here,
                                     const Pose& T_place_seen, const LoopLimits& limits);
  void ask_again(const Surroundings& here, const LoopLimits& limits,
                 std::vector<AskedPlace>& asked);
  void remember(std::vector<AskedPlace> asked);
  [[nodiscard]] Answer only_place(const Surroundings& here);
  [[nodiscard]] bool agree_here(const Pose& one, const Pose& other) const;

  SavedMap map_;
  std::vector<std::size_t> held_;  // which of its pieces are held together: of one frame
  LocalizerOptions options_;
  PlaceIndex index_;
  std::vector<std::pair<std::size_t, std::shared_ptr<const VerifiableSubmap>>> places_;
  PieceBuilder builder_;
  std::vector<Piece> recent_;  // finished ones before it
  PlaceAgreement agreement_;
  std::vector<AskedPlace> fitted_;  // that fitted best when last asked
  std::optional<Pose> T_map_world_;
  std::size_t frame_ = 0;          // of the place that is known
  std::optional<Pose> elsewhere_;  // T_map_world that the last look saw, which was not believed
  std::string message_ = "no scan yet";
  std::size_t scans_ = 0;
  bool looking_ = true;  // at scans, to search or to check
  double way_ = 0.0;
  double checked_at_ = 0.0;    // way
  double succeeded_at_ = 0.0;  // way
  std::optional<Eigen::Vector3d> last_;
};

}  // namespace surefoot::mapping
