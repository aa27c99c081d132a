// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A type of Cyclone DDS whose samples are CDR as it is on the wire: what reads and writes bags does
// the rest. Nothing is said of its members, as ROS 2's own layer for Cyclone says nothing: types
// match by their names.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

struct ddsi_serdata;
struct ddsi_sertype;

namespace surefoot::ros2 {

/// To be handed to dds_create_topic_sertype, which owns it from then on.
[[nodiscard]] ddsi_sertype* make_raw_type(const std::string& name);
/// Samples of the type that came from others so far.
[[nodiscard]] std::uint64_t arrived_samples(const ddsi_sertype* type);

/// A sample to be written to a topic of that type, with one reference.
[[nodiscard]] ddsi_serdata* make_raw_sample(const ddsi_sertype* type, std::string_view cdr);

struct RawSample {
  std::vector<std::byte> bytes;  ///< the encapsulation's four first
  std::int64_t arrival_ns = 0;   ///< when it was complete, since 1970
  std::chrono::steady_clock::time_point received;
};
/// What a sample that was taken holds: others may read it, too.
[[nodiscard]] RawSample copy_raw_sample(const ddsi_serdata* sample);

}  // namespace surefoot::ros2
