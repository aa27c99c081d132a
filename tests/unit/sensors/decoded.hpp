// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A made packet decoded, and where its returns should lie.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "sensors/sensor_list.hpp"
#include "unit/sensors/encoders.hpp"

namespace surefoot::sensors::test {

inline Firings decode(const std::string& payload, const std::string& expected_sensor,
                      const DecoderOptions& options = {}) {
  std::string reason;
  const auto decoder = find_decoder(bytes_of(payload), "", options, reason);
  Firings firings;
  if (decoder == nullptr) {
    ADD_FAILURE() << expected_sensor << " not found: " << reason;
    return firings;
  }
  EXPECT_EQ(decoder->sensor(), expected_sensor);
  EXPECT_EQ(decoder->decode(bytes_of(payload), firings), PacketKind::data);
  return firings;
}

/// Offset of point `i` from the packet's time.
inline std::int64_t time_of(const Firings& firings, std::size_t i) {
  for (const Firing& firing : firings.firings) {
    if (i < firing.end) return firing.offset_ns + firings.points[i].offset_ns;
  }
  return -1;
}

/// Velodyne's and RoboSense's frame; azimuth and elevation in degrees.
inline void expect_at(const FiringPoint& point, double range, double azimuth, double elevation) {
  constexpr double kDegree = M_PI / 180.0;
  const Eigen::Vector3d expected(
      range * std::cos(elevation * kDegree) * std::cos(azimuth * kDegree),
      -range * std::cos(elevation * kDegree) * std::sin(azimuth * kDegree),
      range * std::sin(elevation * kDegree));
  EXPECT_LT((point.position.cast<double>() - expected).norm(), 1e-5)
      << point.position.transpose() << " instead of " << expected.transpose();
}

inline std::vector<unsigned> turning(unsigned from, unsigned step, unsigned blocks_at_once) {
  std::vector<unsigned> azimuths;
  for (unsigned block = 0; block < 12; ++block) {
    azimuths.push_back(from + block / blocks_at_once * step);
  }
  return azimuths;
}

inline constexpr DecoderOptions plain_options() {
  DecoderOptions options;
  options.beam_origins = false;
  return options;
}

}  // namespace surefoot::sensors::test
