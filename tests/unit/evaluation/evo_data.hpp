// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// evo's test data, read with the least that this takes: the files are known to be good.
#pragma once

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "surefoot/trajectory.hpp"

namespace surefoot::evaluation::test {

inline std::filesystem::path evo_data(const std::string& name) {
  return std::filesystem::path(SUREFOOT_SHARED_DATA) / "evo_trajectories" / name;
}

/// Nanoseconds of a decimal number of seconds, exactly; with an exponent, as near as doubles are.
inline std::int64_t nanoseconds(const std::string& seconds) {
  if (seconds.find('e') != std::string::npos) return std::llround(1e9 * std::stod(seconds));
  const std::size_t point = seconds.find('.');
  std::string fraction = point == std::string::npos ? "" : seconds.substr(point + 1);
  fraction.resize(9, '0');
  return std::stoll(seconds.substr(0, point)) * 1'000'000'000 + std::stoll(fraction);
}

/// Lines of `t x y z qx qy qz qw`.
inline Trajectory read_tum(const std::filesystem::path& path) {
  std::ifstream file(path);
  Trajectory trajectory;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line.front() == '#') continue;
    std::istringstream fields(line);
    std::string seconds;
    Eigen::Vector3d t;
    Eigen::Quaterniond q;
    fields >> seconds >> t.x() >> t.y() >> t.z() >> q.x() >> q.y() >> q.z() >> q.w();
    trajectory.push_back({nanoseconds(seconds), {q.normalized(), t}});
  }
  return trajectory;
}

/// Lines of `ns,x,y,z,qw,qx,qy,qz,...`, as the EuRoC data have them.
inline Trajectory read_euroc(const std::filesystem::path& path) {
  std::ifstream file(path);
  Trajectory trajectory;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line.front() == '#') continue;
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream fields(line);
    std::int64_t stamp_ns = 0;
    Eigen::Vector3d t;
    Eigen::Quaterniond q;
    fields >> stamp_ns >> t.x() >> t.y() >> t.z() >> q.w() >> q.x() >> q.y() >> q.z();
    trajectory.push_back({stamp_ns, {q.normalized(), t}});
  }
  return trajectory;
}

/// Lines of twelve numbers, a 3x4 matrix row by row; the stamp is the line's number in seconds.
/// The files have seven digits, so that the nearest rotation is taken.
inline Trajectory read_kitti(const std::filesystem::path& path) {
  std::ifstream file(path);
  Trajectory trajectory;
  for (std::string line; std::getline(file, line);) {
    std::istringstream fields(line);
    Eigen::Matrix<double, 3, 4> matrix;
    for (int i = 0; i < 12; ++i) fields >> matrix(i / 4, i % 4);
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(matrix.leftCols<3>(),
                                                Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Eigen::Matrix3d rotation = svd.matrixU() * svd.matrixV().transpose();
    trajectory.push_back({static_cast<std::int64_t>(trajectory.size()) * 1'000'000'000,
                          {Eigen::Quaterniond(rotation).normalized(), matrix.col(3)}});
  }
  return trajectory;
}

}  // namespace surefoot::evaluation::test
