// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A LiDAR carried through a scene: scans whose every point is measured from the pose that the
// sensor has at the point's own instant.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "simulation/airborne.hpp"
#include "simulation/lidar_model.hpp"
#include "simulation/motion.hpp"
#include "simulation/ray_caster.hpp"
#include "simulation/return_model.hpp"
#include "simulation/rotor.hpp"
#include "simulation/sequence_path.hpp"
#include "surefoot/scan.hpp"
#include "surefoot/trajectory.hpp"

namespace surefoot::simulation {

struct ScannerOptions {
  std::uint64_t seed = 0;
  std::int64_t start_ns = 1'000'000'000'000;  ///< stamp of time 0
  bool footprint = true;     ///< several rays a beam: mixed pixels, slanted surfaces
  bool dual_return = false;  ///< strongest and last instead of the strongest alone
  bool robot_body = false;   ///< the robot's own trunk is in view
  AirOptions air = {};       ///< rain and dust
};

/// One return, for the sensor's own packets.
struct RawReturn {
  std::uint64_t sequence = 0;  ///< firing sequence, counted from time 0
  std::uint16_t laser = 0;     ///< index into LidarModel::lasers
  bool last = false;           ///< of two returns, the farther one
  double range = 0.0;          ///< [m]
  std::uint8_t intensity = 0;
};

struct SimulatedScan {
  Scan scan;
  std::int64_t end_ns = 0;                   ///< instant of the next scan's first firing
  std::vector<RawReturn> raw;                ///< one a point, same order
  std::vector<Eigen::Vector3d> true_points;  ///< one a point: where it was met, map frame, no noise
  std::vector<std::uint8_t> labels;          ///< one a point: PointLabel
  std::uint64_t first_sequence = 0;
  std::uint64_t end_sequence = 0;
};

enum PointLabel : std::uint8_t {
  kLabelStatic,
  kLabelMoving,
  kLabelMixed,
  kLabelRobot,
  kLabelMirrored,  ///< seen in a pane: nothing is at this place
  kLabelAir        ///< a drop or dust
};

class Scanner {
 public:
  /// @param rays is used for every scan and must outlive the scanner.
  Scanner(RayCaster& rays, const LidarModel& model, const Motion& motion,
          const ScannerOptions& options);

  /// Scans that the motion lasts for.
  [[nodiscard]] std::uint64_t scan_count() const;
  /// Scan `index`, whichever was asked before. The first firing sequence that starts in a turn is
  /// the scan's first. Points come in the order of their firing.
  [[nodiscard]] SimulatedScan scan(std::uint64_t index);

  /// First sequence of a scan.
  [[nodiscard]] std::uint64_t first_sequence(std::uint64_t index) const;
  /// Instant of a firing since time 0 [ns].
  [[nodiscard]] double firing_ns(std::uint64_t sequence, std::size_t laser) const;
  /// Azimuth of the rotor that the sensor reports for a firing, clockwise [rad], in [0, 2 pi).
  [[nodiscard]] double reported_azimuth(std::uint64_t sequence, std::size_t laser) const;
  [[nodiscard]] const LidarModel& model() const { return model_; }
  [[nodiscard]] const Motion& motion() const { return motion_; }
  [[nodiscard]] const ScannerOptions& options() const { return options_; }

 private:
  /// A laser in the frame of the rotor, which is the LiDAR's turned to the rotor's azimuth.
  struct RotorBeam {
    Eigen::Vector3d origin;
    Eigen::Vector3d direction;
    std::vector<Eigen::Vector3d> footprint;  ///< directions of its rays
    double share = 0.0;                      ///< of a firing sequence's time, when it fires
    SineCosine turned;                       ///< azimuth that the rotor turned until then
  };
  /// One firing: the rotor's pose in the map at its instant.
  struct Firing {
    std::uint64_t sequence = 0;
    double time_ns = 0.0;
    double reported_azimuth = 0.0;
    Rotor rotor;
    Eigen::Matrix3d R_map_rotor;
    Eigen::Vector3d position;
  };
  /// Consecutive firing sequences that are cast together.
  struct Block {
    std::uint64_t first = 0;
    std::size_t sequences = 0;
  };
  /// The rotor's azimuth as the sensor last read it.
  struct AzimuthReading {
    double time_ns = 0.0;
    double azimuth = 0.0;
  };

  [[nodiscard]] double true_azimuth(double time_ns) const;
  [[nodiscard]] AzimuthReading azimuth_reading(std::uint64_t sequence) const;
  [[nodiscard]] double azimuth_after(const AzimuthReading& reading, double time_ns) const;
  void follow(const Block& block);
  void fire(const Block& block);
  void fire(const Block& block, std::size_t laser);
  void aim(const Block& block, double begin_ns, double end_ns);
  void aim_at_body(const Block& block);
  void hide_behind_body();
  void collect(const Block& block, SimulatedScan& result) const;
  void add_airborne(const Firing& firing, std::size_t laser, BeamReturns& returns) const;
  void report(const Firing& firing, std::size_t laser, const BeamReturn& value, bool last,
              SimulatedScan& result) const;
  [[nodiscard]] std::size_t slot(std::size_t laser, std::size_t sequence) const;

  RayCaster* rays_;
  LidarModel model_;
  Motion motion_;
  ScannerOptions options_;
  CounterRandom random_;
  Airborne air_;
  std::span<const FootprintRay> footprint_;
  std::vector<RotorBeam> beams_;  ///< one a laser
  std::unique_ptr<RayCaster> body_;
  // Working memory of one block, laser by laser, sequence by sequence: neighbours in it point
  // nearly the same way, which ray packets reward with twice the speed.
  std::vector<AzimuthReading> readings_;  ///< one a sequence, as the next two
  std::vector<SequencePath> paths_;
  std::vector<SineCosine> azimuths_;  ///< true ones, at the sequence's begin
  std::vector<Firing> firings_;
  std::vector<Ray> aimed_;
  std::vector<Hit> hits_;
  std::vector<Hit> body_hits_;
};

/// Truth: the LiDAR's pose every 2.5 ms and at the start, the middle and the end of every scan.
[[nodiscard]] Trajectory true_trajectory(const Scanner& scanner, std::uint64_t scans);

}  // namespace surefoot::simulation
