// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "surefoot/config.hpp"
#include "surefoot/estimate.hpp"
#include "surefoot/scan.hpp"

namespace surefoot {

/// The steps of one scan, for whoever measures their time. A method need not take all of them,
/// takes them in its own order, and search and solve by turns.
enum class Step {
  preprocess,  ///< checks, range limits, times
  deskew,      ///< points to one instant
  downsample,  ///< which points are registered, which enter the map
  search,      ///< what of the map a point lies on
  solve,       ///< the pose, in all stages of the registration
  assess,      ///< whether it is plausible, its covariance
  map,         ///< what the next scan is registered to
  idle         ///< the scan is finished
};
/// Told when a step begins.
using StepObserver = std::function<void(Step)>;

/// How the map's level frame was found.
struct LevelReport {
  LevelMode mode = LevelMode::none;
  bool from_ground = false;    ///< a ground plane was found and defines "level"
  double tilt_deg = 0.0;       ///< between the LiDAR's z axis and the map's
  double ground_height = 0.0;  ///< of the sensor above that ground [m]
  std::string message;         ///< one sentence for the user
};

/// A scan's points at its mid-scan instant; order and number as the valid points of the scan.
struct DeskewedScan {
  std::vector<Eigen::Vector3f> points;  ///< [m] LiDAR frame at Estimate::stamp_ns
  std::vector<float> intensities;       ///< empty or one per point
};

/// Cubes along the axes of the map's frame.
struct Cubes {
  double side = 0.0;                     ///< [m]
  std::vector<Eigen::Vector3d> centres;  ///< [m] world frame
};

class FrontEnd;
class Reference;
struct Session;

/// LiDAR odometry: one scan in, one estimate out, by the method that the configuration names.
///
/// The same scans give the same bits, at any number of threads. Nothing is printed, no clock is
/// read. An object belongs to one thread at a time.
class Odometry {
 public:
  /// Throws ConfigError. `T_world_start`: where the map's frame lies in the caller's world; poses
  /// come out in that world, the arithmetic stays near the start. It should not tilt the world,
  /// since "vertical" is the map's z axis. `threads`: at most this many; 1 where the
  /// library was built without threads.
  explicit Odometry(const Config& config = {}, int threads = 1, const Pose& T_world_start = {});
  ~Odometry();
  Odometry(const Odometry&) = delete;
  Odometry& operator=(const Odometry&) = delete;
  Odometry(Odometry&&) noexcept;
  Odometry& operator=(Odometry&&) noexcept;

  /// Never throws for what is in a scan: a scan that cannot be used is `rejected`. So is one whose
  /// stamp is not after the last one's; ten in a row whose stamps rise tell that the clock was set
  /// back, and the next ones are taken as they come. With more than one thread a scan goes on into
  /// the local map after its estimate was returned; who asks for the map, or adds another scan,
  /// waits for that.
  Estimate add_scan(const Scan& scan);

  [[nodiscard]] const Config& config() const;
  [[nodiscard]] const LevelReport& level() const;
  /// The last scan that was not rejected, made when it is asked for; valid until the next one.
  [[nodiscard]] const DeskewedScan& deskewed_scan() const;
  /// The local map's points, in the world frame [m].
  [[nodiscard]] std::vector<Eigen::Vector3d> local_map() const;
  /// Where the last scan looked through what had been seen before: it has moved away, and who keeps
  /// a map of their own may forget it, too. Method surefoot only; else none.
  [[nodiscard]] Cubes emptied_cubes() const;

  /// Called whenever a step begins (and with Step::idle at the end of a scan). The library reads
  /// no clock; the observer may.
  void set_step_observer(StepObserver observer);

 private:
  friend class Reference;  // whose answers are known beforehand
  using MakeFrontEnd = std::function<std::unique_ptr<FrontEnd>(const Session& session)>;
  Odometry(const Config& config, int threads, const MakeFrontEnd& make_front_end);
  /// What was added to the last scan's stamps where the clock was set back before it.
  [[nodiscard]] std::int64_t ahead_ns() const;

  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace surefoot
