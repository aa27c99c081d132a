// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The way cut into pieces: what a map is made of, and what a pose graph moves.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/voxel_table.hpp"
#include "mapping/cloud_file.hpp"
#include "mapping/kept_scan.hpp"
#include "mapping/walk_clock.hpp"
#include "surefoot/odometry.hpp"

namespace surefoot::mapping {

/// A scan as the odometry placed it.
struct PlacedScan {
  std::int64_t stamp_ns = 0;
  Pose T_world_lidar;
  Matrix6 covariance = Matrix6::Zero();  ///< as Estimate::covariance
  bool restarted = false;                ///< the odometry is in another frame than before
  int frame = 0;                         ///< poses of one number are in one frame
};

/// Makes a scan's points when they are asked for: most scans' never are.
using ScanPoints = std::function<const DeskewedScan&()>;
/// Those that are there; they must outlive what is returned.
[[nodiscard]] inline ScanPoints ready(const DeskewedScan& points) {
  return [&points]() -> const DeskewedScan& { return points; };
}

/// [m] at which a rotation moves points as much as a shift of the same size.
inline constexpr double kLever = 10.0;
/// [m^2] How far a pose's points may lie astray.
[[nodiscard]] double spread(const Matrix6& covariance);
/// Whether the odometry was sure of a pose: what is seen from one that lies farther astray than any
/// loop may would bend the rest.
[[nodiscard]] bool is_sure(const Matrix6& covariance);
/// A covariance in some axes in those of a frame that is turned in them.
[[nodiscard]] Matrix6 turned(const Matrix6& covariance, const Eigen::Quaterniond& R_axes_frame);

/// A few metres of way: what was seen from it, thinned, in the frame of the pose in its middle,
/// made level.
struct Piece : PieceCloud {
  std::int64_t begin_ns = 0;             ///< of its first scan, along the walk (WalkClock)
  std::int64_t time_ns = 0;              ///< of its middle, along the walk
  std::int64_t stamp_ns = 0;             ///< of its middle, by the sensor's clock
  Pose T_world_piece;                    ///< of its middle by the odometry, level
  Pose T_piece_lidar;                    ///< the LiDAR there, which is not level
  double way = 0.0;                      ///< walked until its middle [m]
  double length = 0.0;                   ///< of way in it [m]
  Matrix6 covariance = Matrix6::Zero();  ///< the front-end's, of the least certain pose in it
                                         ///< against its map; [x y z roll pitch yaw], its axes
  bool restarted = false;                ///< where it lies against the piece before is not known
  int frame = 0;                         ///< of the odometry, as PlacedScan has it; of a walk only
  /// The cloud, once it was put away; then the piece itself holds none.
  std::shared_ptr<const StoredCloud> stored;
  /// As seen_in() tells it, if that was asked for.
  std::shared_ptr<const StoredBytes> things;
};

/// What was seen from a piece, wherever it is. It must not outlive the piece.
[[nodiscard]] std::shared_ptr<const PieceCloud> cloud_of(const Piece& piece);
/// Packs a piece's cloud and what was seen of things away, into the file if there is one.
void put_away(Piece& piece, const std::shared_ptr<CloudFile>& file);

struct PieceOptions {
  double length = 5.0;      ///< of way [m]
  double voxel = 0.2;       ///< one point a cube: the mean [m]
  double range = 50.0;      ///< what is farther away is left out [m]
  double step = 0.2;        ///< scans nearer to the last one add little and are passed over [m]
  double turn = 0.25;       ///< unless the LiDAR turned by so much [rad]
  std::size_t always = 10;  ///< scans of a piece: a robot that stands sees something, too
  bool things = false;      ///< whether what moved will be asked about
};

/// Cuts the way into pieces while it is walked.
class PieceBuilder {
 public:
  explicit PieceBuilder(const PieceOptions& options) : options_(options) {}

  /// The piece that this scan ends, if it does; the scan begins the next one.
  [[nodiscard]] std::optional<Piece> add(const PlacedScan& scan, const ScanPoints& points);
  [[nodiscard]] std::optional<Piece> add(const PlacedScan& scan, const DeskewedScan& points) {
    return add(scan, ready(points));
  }
  /// What is there of the last piece.
  [[nodiscard]] std::optional<Piece> finish();
  /// What there is of the piece that is being walked; none before the first scan.
  [[nodiscard]] std::optional<Piece> unfinished() const;
  /// Places that are remembered of it: no more where the robot stands for long.
  [[nodiscard]] std::size_t places() const { return stands_.size(); }

 private:
  struct Cube {
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    std::uint32_t count = 0;
    std::uint16_t eye = 0;
  };
  struct Stand {
    std::int64_t stamp_ns = 0, time_ns = 0;
    Pose pose;
    double way = 0.0;
  };

  void begin(const PlacedScan& scan);
  void insert(const PlacedScan& scan, const ScanPoints& points);
  void look(const PlacedScan& scan, const DeskewedScan& points);
  [[nodiscard]] std::string things_seen(const Piece& piece);

  PieceOptions options_;
  WalkClock clock_;
  std::int64_t now_ns_ = 0;  // along the walk
  double way_ = 0.0;
  Eigen::Vector3d counted_ = Eigen::Vector3d::Zero();  // the way is counted up to here
  // Of the piece that is being walked; its points in the level frame of its first scan.
  bool begun_ = false;
  bool restarted_ = false;
  int frame_ = 0;
  std::int64_t begin_ns_ = 0;
  double begin_way_ = 0.0;
  Pose T_world_first_;
  Matrix6 covariance_ = Matrix6::Zero();  // of the least certain pose, in the world's axes
  std::size_t scans_ = 0;
  std::vector<Stand> stands_;
  VoxelTable table_;
  std::vector<Cube> cubes_;
  std::vector<Eigen::Vector3f> eyes_;
  Pose last_inserted_;
  std::vector<KeptScan> looks_;
  std::int64_t between_looks_ns_ = 0;  // at least, of a piece that takes long
};

}  // namespace surefoot::mapping
