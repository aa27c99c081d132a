// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The other side of ROS 2's wire: Fast DDS, which most ROS 2 systems run, with CDR by Fast CDR.
// Neither shares a line with Cyclone DDS or with what Surefoot reads and writes messages with.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "surefoot/scan.hpp"

namespace surefoot::test {

/// sensor_msgs/PointCloud2 of a scan: x y z intensity t ring, as drivers publish it.
[[nodiscard]] std::string cloud_by_fast_cdr(const Scan& scan, const std::string& frame);

/// velodyne_msgs/VelodyneScan of packets of 1206 bytes, all of the same stamp.
[[nodiscard]] std::string velodyne_scan_by_fast_cdr(std::span<const std::string> packets,
                                                    std::int64_t stamp_ns);

struct OdometryFields {
  std::int64_t stamp_ns = 0;
  std::string frame, child_frame;
  std::vector<double> numbers;  ///< pose 7, covariance 36, twist 6, covariance 36
};
[[nodiscard]] OdometryFields odometry_by_fast_cdr(const std::string& cdr);

/// What an endpoint tells of itself when it is discovered.
struct Discovered {
  std::string topic, type, user_data;
  bool reliable = false;
  bool transient_local = false;
};

/// A participant on the loopback interface alone, found without multicast.
class FastDdsPeer {
 public:
  explicit FastDdsPeer(int domain);
  ~FastDdsPeer();
  FastDdsPeer(const FastDdsPeer&) = delete;
  FastDdsPeer& operator=(const FastDdsPeer&) = delete;

  /// `topic` and `type` as on the wire.
  void add_writer(const std::string& topic, const std::string& type, bool reliable = true);
  void add_reader(const std::string& topic, const std::string& type, bool reliable = true,
                  bool transient_local = false);
  void write(const std::string& topic, const std::string& cdr);
  /// Until so many readers listen to a topic that is written.
  [[nodiscard]] bool wait_for_readers(const std::string& topic, int readers = 1);
  /// What came so far.
  [[nodiscard]] std::vector<std::string> take(const std::string& topic);
  [[nodiscard]] std::vector<Discovered> writers() const;
  [[nodiscard]] std::vector<std::string> participants() const;  ///< their user data

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace surefoot::test
