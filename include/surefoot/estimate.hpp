// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "surefoot/pose.hpp"
#include "surefoot/scan_trajectory.hpp"

namespace surefoot {

/// Whether a pose can be trusted.
enum class Status {
  ok,               ///< registered, every direction observed
  first_scan,       ///< the map begins (again) with this scan; the pose is the prediction
  degenerate,       ///< registered, but the directions named in `degenerate` rest on little
  too_few_matches,  ///< not registered: the pose is the prediction, the map is unchanged
  diverged,         ///< registration ended somewhere implausible: likewise
  lost,             ///< it does not know where it is and searches: the pose is a guess, likewise
  rejected          ///< the scan could not be used, `message` says why; nothing changed
};
[[nodiscard]] std::string_view to_string(Status status);

/// What one stage of the registration did.
struct StageReport {
  std::string_view name;       ///< "registration" where a method has no other; lives for ever
  int iterations = 0;          ///< updates that were solved and applied
  int matches = 0;             ///< correspondences in the last of them
  double residual = 0.0;       ///< [m] weighted RMS over these
  double observability = 0.0;  ///< method paper's vertical stage: mean of Omega_i, eq. (30)
};

/// The stages of a registration in their order; none of a scan that was not registered.
class StageReports {
 public:
  static constexpr std::size_t kMost = 2;  ///< of any method

  StageReports() = default;
  StageReports(const StageReport& only) : reports_{only}, size_(1) {}
  StageReports(const StageReport& first, const StageReport& second)
      : reports_{first, second}, size_(2) {}

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] const StageReport& operator[](std::size_t place) const { return reports_[place]; }
  [[nodiscard]] const StageReport* begin() const { return reports_.data(); }
  [[nodiscard]] const StageReport* end() const { return reports_.data() + size_; }

 private:
  std::array<StageReport, kMost> reports_;
  std::size_t size_ = 0;
};

/// A motion that the scan hardly constrains.
struct DegenerateDirection {
  Twist direction = Twist::Zero();  ///< unit vector in the world's axes about the sensor; the three
                                    ///< rotations are scaled by the matches' RMS distance [1/m]
  double information = 0.0;         ///< its share of what an evenly built scene would give (1)
  std::string name;                 ///< its largest part, seen along the sensor's heading:
                                    ///< forward, lateral, up, roll, pitch or yaw
};

/// What speaks against a registered pose, in figures that do not depend on the scene: 0 where
/// nothing does. docs/method.md, "Is it right?".
struct Evidence {
  // Logarithms of ratios to what is usual for this run; 0: usual or less.
  double misfit = 0.0;         ///< of the points to what the map has seen
  double unseen = 0.0;         ///< share of the points where the map has nothing
  double contradiction = 0.0;  ///< share that scans went through of each other
  double motion = 0.0;         ///< against the velocity model
  double unconverged = 0.0;    ///< that its updates did not become small soon
  // Others.
  double uncertainty = 0.0;  ///< logarithm of the standard deviation over 1 cm
  double gap = 0.0;          ///< of the time since the last trusted scan over 0.1 s
  double frozen = 0.0;       ///< up to 1: the same scan again, byte by byte, of who walked
  double rival = 0.0;        ///< ln of what it disagrees over what another place does; < 0: found
};

struct EvidenceField {
  const char* name;
  double Evidence::*member;
};
inline constexpr std::array<EvidenceField, 9> kEvidenceFields = {{
    {"misfit", &Evidence::misfit},
    {"unseen", &Evidence::unseen},
    {"contradiction", &Evidence::contradiction},
    {"motion", &Evidence::motion},
    {"unconverged", &Evidence::unconverged},
    {"uncertainty", &Evidence::uncertainty},
    {"gap", &Evidence::gap},
    {"frozen", &Evidence::frozen},
    {"rival", &Evidence::rival},
}};

/// The answer to one scan.
struct Estimate {
  Status status = Status::rejected;
  /// Poses of one segment are in one frame. Where it lost itself and did not find itself again, the
  /// next segment begins: how they lie to each other is not known. Where it comes back to what an
  /// earlier segment mapped it goes on in that one, under its number.
  int segment = 0;
  std::string message;  ///< what was seen and expected; empty when ok

  std::int64_t stamp_ns = 0;    ///< mid-scan, the instant of `T_world_lidar`
  Pose T_world_lidar;           ///< pose at mid-scan
  ScanTrajectory trajectory;    ///< poses within the scan, as its points were deskewed
  Twist twist = Twist::Zero();  ///< mean velocity of the last motion, LiDAR frame [m/s, rad/s]
  Matrix6 covariance = Matrix6::Zero();  ///< of the pose against the map; [x y z roll pitch yaw]
                                         ///< in the world's axes about the sensor
                                         ///< [m^2, m rad, rad^2]
  std::vector<DegenerateDirection> degenerate;

  /// Of a registered scan; the default method alone tells.
  Evidence evidence;
  /// That the pose is wrong by more than 0.2 m or 3 degrees against that of ten scans before; NaN
  /// where that is not told: by other methods, and of scans that were not registered.
  double wrong_probability = std::numeric_limits<double>::quiet_NaN();

  bool converged = false;     ///< the last update was below the method's convergence
  StageReports stages;        ///< of the registration, named as the method names them
  int points = 0;             ///< valid points of the scan
  int registered_points = 0;  ///< of these, after thinning, registered

  /// T_world_lidar at any instant of the scan [ns, sensor's epoch].
  [[nodiscard]] Pose pose_at(std::int64_t instant_ns) const {
    return trajectory.at_time(instant_ns);
  }
  /// Whether the scan was registered (or began the map), so that the pose was measured.
  [[nodiscard]] bool trusted() const {
    return status == Status::ok || status == Status::first_scan || status == Status::degenerate;
  }
};

}  // namespace surefoot
