// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The other side of ROS 2's wire as Cyclone DDS itself has it: types that its compiler (idlc) makes
// of their IDL, written and read as structures. What Surefoot has in its place is bytes.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "surefoot/scan.hpp"

namespace surefoot::test {

/// nav_msgs/Odometry, as far as it is compared.
struct HeardOdometry {
  std::int64_t stamp_ns = 0;
  std::string frame, child_frame;
  std::vector<double> numbers;  ///< pose 7, covariance 36, twist 6, covariance 36
};

/// tf2_msgs/TFMessage: "odom > lidar" of each transform.
using HeardTransforms = std::vector<std::string>;

/// A participant on the loopback interface alone, without multicast.
class CyclonePeer {
 public:
  /// Publishes clouds on `cloud_topic` ("rt/points"), hears what Surefoot publishes.
  CyclonePeer(int domain, const std::string& cloud_topic);
  ~CyclonePeer();
  CyclonePeer(const CyclonePeer&) = delete;
  CyclonePeer& operator=(const CyclonePeer&) = delete;

  /// Until somebody hears the clouds, and somebody publishes odometry.
  [[nodiscard]] bool wait_for_peer() const;
  void write(const Scan& scan);
  [[nodiscard]] std::vector<HeardOdometry> odometry() const;
  [[nodiscard]] std::vector<HeardTransforms> transforms() const;
  [[nodiscard]] std::vector<std::size_t> cloud_sizes() const;  ///< of /surefoot/scan [points]

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace surefoot::test
