// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// All scans of a way at once: the knots of each of them against the map of all of them.
// docs/reference.md.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/front_end.hpp"
#include "core/preprocess.hpp"
#include "methods/knots/banded_system.hpp"
#include "methods/knots/knot_window.hpp"
#include "methods/knots/surfel_map.hpp"
#include "methods/knots/velocity_model.hpp"

namespace surefoot {

/// The scans of one segment, all in one frame. The knots of a scan begin where those of the scan
/// before end, but after a gap: one chain, as long as the way.
class WholeWay {
 public:
  explicit WholeWay(const Session& session);

  /// A scan that was registered: what is to be kept of its points, with their times, and what the
  /// odometry said of it. Returns whether it is one of the chain: none is that ends with the scan
  /// before.
  bool add(PreparedScan scan, const Estimate& estimate);

  [[nodiscard]] std::size_t size() const { return scans_.size(); }

  /// Maps all scans as they lie, moves all knots to where that map has them, and the whole so that
  /// the first scan's middle stays. Returns whether that could be done: the normal equations had
  /// a finite solution. Else nothing is moved.
  bool refine();

  [[nodiscard]] ScanTrajectory trajectory(std::size_t scan) const;
  /// Of the middle of a scan against the map, the odometry's until refine(): [x y z roll pitch
  /// yaw], map axes.
  [[nodiscard]] const Matrix6& covariance(std::size_t scan) const {
    return scans_[scan].covariance;
  }

 private:
  struct WayScan {
    PreparedScan scan;
    KnotWindow window;
    std::size_t first;  // knot of the chain that is the window's first
    VelocityModel model;
    Matrix6 covariance;  // of its middle
  };
  /// Of a scan's knots, before those of all scans are added up.
  struct Equations {
    BandedSystem system;
    double squares = 0.0;  // sum of the weighted residuals'
    int count = 0;
  };

  [[nodiscard]] std::size_t knots() const;
  void map_all();
  [[nodiscard]] Equations equations_of(const WayScan& way) const;
  [[nodiscard]] std::vector<Equations> all_equations() const;
  bool move(const std::vector<Twist>& steps);
  void anchor(const Pose& T_map_first);
  void learn(const std::vector<Equations>& equations, const BandedSystem::Covariance& of_all);

  const Session& session_;
  Config::Knots config_;
  SurfelMap map_;
  std::vector<WayScan> scans_;
};

}  // namespace surefoot
