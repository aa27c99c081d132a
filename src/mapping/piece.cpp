// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/piece.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/voxel_key.hpp"
#include "geometry/se3.hpp"
#include "mapping/submap.hpp"
#include "mapping/thing_sight.hpp"

namespace surefoot::mapping {

namespace {

constexpr double kSway = 0.2;  // smaller steps are the body's sway, not way [m]
constexpr std::size_t kMostEyes = std::numeric_limits<std::uint16_t>::max();
constexpr std::size_t kMostLooks = 64;     // of a piece
constexpr std::size_t kMostBeams = 30000;  // of a look

}  // namespace

double spread(const Matrix6& covariance) {
  const Twist variances = covariance.diagonal();
  return variances.head<3>().sum() + kLever * kLever * variances.tail<3>().sum();
}

bool is_sure(const Matrix6& covariance) {
  constexpr double kSure = 0.092;  // [m] standard deviation, kLever away
  return spread(covariance) < kSure * kSure;
}

Matrix6 turned(const Matrix6& covariance, const Eigen::Quaterniond& R_axes_frame) {
  const Matrix6 turn = turned_axes(R_axes_frame.conjugate());
  return turn * covariance * turn.transpose();
}

std::shared_ptr<const PieceCloud> cloud_of(const Piece& piece) {
  if (piece.stored) return std::make_shared<const PieceCloud>(piece.stored->cloud());
  return {std::shared_ptr<void>(), &piece};
}

void put_away(Piece& piece, const std::shared_ptr<CloudFile>& file) {
  if (piece.stored) return;
  if (piece.things) {
    piece.things = std::make_shared<const StoredBytes>(put_into(file, piece.things->packed()));
  }
  piece.stored = store(piece, file);
  static_cast<PieceCloud&>(piece) = PieceCloud{};
}

std::optional<Piece> PieceBuilder::add(const PlacedScan& scan, const ScanPoints& points) {
  std::optional<Piece> done;
  now_ns_ = clock_.next(scan.stamp_ns);
  if (begun_ && scan.restarted) {
    done = finish();
    counted_ = scan.T_world_lidar.translation;
  }
  const double step = (scan.T_world_lidar.translation - counted_).norm();
  if (begun_ && step > kSway) {
    way_ += step;
    counted_ = scan.T_world_lidar.translation;
  }
  if (begun_ && way_ - begin_way_ >= options_.length) done = finish();
  if (!begun_) begin(scan);
  insert(scan, points);
  return done;
}

void PieceBuilder::begin(const PlacedScan& scan) {
  if (eyes_.empty() && way_ == 0.0) counted_ = scan.T_world_lidar.translation;
  begun_ = true;
  restarted_ = scan.restarted;
  frame_ = scan.frame;
  begin_ns_ = now_ns_;
  begin_way_ = way_;
  T_world_first_ = upright(scan.T_world_lidar);
  covariance_.setZero();
  scans_ = 0;
  stands_.clear();
  table_.clear();
  cubes_.clear();
  eyes_.clear();
  looks_.clear();
  between_looks_ns_ = 0;
}

/// Of many looks every second one is let go, and as seldom they are taken from then on.
void PieceBuilder::look(const PlacedScan& scan, const DeskewedScan& points) {
  if (looks_.size() == kMostLooks) {
    for (std::size_t i = 1; 2 * i < kMostLooks; ++i) looks_[i] = std::move(looks_[2 * i]);
    looks_.resize(kMostLooks / 2);
    between_looks_ns_ = 2 * (now_ns_ - begin_ns_) / std::int64_t{kMostLooks};
  }
  const Pose T_first_lidar = T_world_first_.inverse() * scan.T_world_lidar;
  const Eigen::Matrix3f R = T_first_lidar.rotation.toRotationMatrix().cast<float>();
  KeptScan look{now_ns_, T_first_lidar.translation.cast<float>(), {}};
  const std::size_t every = points.points.size() / kMostBeams + 1;
  look.points.reserve(points.points.size() / every + 1);
  for (std::size_t i = 0; i < points.points.size(); i += every) {
    look.points.emplace_back(R * points.points[i] + look.eye);
  }
  looks_.push_back(std::move(look));
}

std::string PieceBuilder::things_seen(const Piece& piece) {
  const Pose T_piece_first = piece.T_world_piece.inverse() * T_world_first_;
  const Eigen::Matrix3f R = T_piece_first.rotation.toRotationMatrix().cast<float>();
  const Eigen::Vector3f t = T_piece_first.translation.cast<float>();
  for (KeptScan& look : looks_) {
    look.eye = R * look.eye + t;
    for (Eigen::Vector3f& point : look.points) point = R * point + t;
  }
  return seen_in(looks_, PieceGround(make_submap(piece)));
}

void PieceBuilder::insert(const PlacedScan& scan, const ScanPoints& points) {
  // One scan that was placed badly bends the whole piece.
  if (spread(scan.covariance) > spread(covariance_)) covariance_ = scan.covariance;
  ++scans_;
  // One a place: of those that stood there unfinished() takes the first.
  if (stands_.empty() || way_ != stands_.back().way) {
    stands_.push_back({scan.stamp_ns, now_ns_, scan.T_world_lidar, way_});
  }
  const double moved = (scan.T_world_lidar.translation - last_inserted_.translation).norm();
  const double turn = scan.T_world_lidar.rotation.angularDistance(last_inserted_.rotation);
  const bool taken = scans_ <= options_.always || moved > options_.step || turn > options_.turn;
  const bool looked = !looks_.empty() && now_ns_ - looks_.back().stamp_ns < between_looks_ns_;
  if (options_.things && !looked) look(scan, points());
  if (!taken || eyes_.size() >= kMostEyes) return;
  last_inserted_ = scan.T_world_lidar;
  const Pose T_first_lidar = T_world_first_.inverse() * scan.T_world_lidar;
  const Eigen::Matrix3f R = T_first_lidar.rotation.toRotationMatrix().cast<float>();
  const Eigen::Vector3f t = T_first_lidar.translation.cast<float>();
  const auto eye = static_cast<std::uint16_t>(eyes_.size());
  eyes_.push_back(t);
  const auto range2 = static_cast<float>(options_.range * options_.range);
  const double inverse = 1.0 / options_.voxel;
  for (const Eigen::Vector3f& point : points().points) {
    if (!(point.squaredNorm() < range2)) continue;
    const Eigen::Vector3f at = R * point + t;
    const auto key = voxel_key(voxel_index(at.cast<double>(), inverse));
    const auto [index, fresh] =
        table_.find_or_insert(key, static_cast<std::uint32_t>(cubes_.size()));
    if (fresh) cubes_.push_back({Eigen::Vector3f::Zero(), 0, eye});
    cubes_[index].sum += at;
    ++cubes_[index].count;
  }
}

std::optional<Piece> PieceBuilder::unfinished() const {
  if (!begun_ || stands_.empty()) return std::nullopt;
  const double middle_way = 0.5 * (begin_way_ + way_);
  const Stand& middle =
      *std::min_element(stands_.begin(), stands_.end(), [&](const Stand& a, const Stand& b) {
        return std::abs(a.way - middle_way) < std::abs(b.way - middle_way);
      });
  Piece piece;
  piece.begin_ns = begin_ns_;
  piece.time_ns = middle.time_ns;
  piece.stamp_ns = middle.stamp_ns;
  piece.T_world_piece = upright(middle.pose);
  piece.T_piece_lidar = piece.T_world_piece.inverse() * middle.pose;
  piece.way = middle.way;
  piece.length = way_ - begin_way_;
  piece.covariance = turned(covariance_, piece.T_world_piece.rotation);
  piece.restarted = restarted_;
  piece.frame = frame_;
  const Pose T_piece_first = piece.T_world_piece.inverse() * T_world_first_;
  const Eigen::Matrix3f R = T_piece_first.rotation.toRotationMatrix().cast<float>();
  const Eigen::Vector3f t = T_piece_first.translation.cast<float>();
  for (const Eigen::Vector3f& eye : eyes_) piece.eyes.emplace_back(R * eye + t);
  piece.points.reserve(cubes_.size());
  piece.seen_from.reserve(cubes_.size());
  for (const Cube& cube : cubes_) {
    piece.points.emplace_back(R * (cube.sum / static_cast<float>(cube.count)) + t);
    piece.seen_from.push_back(cube.eye);
  }
  return piece;
}

std::optional<Piece> PieceBuilder::finish() {
  std::optional<Piece> piece = unfinished();
  if (piece && options_.things) {
    piece->things = std::make_shared<const StoredBytes>(things_seen(*piece));
  }
  begun_ = false;
  return piece;
}

}  // namespace surefoot::mapping
