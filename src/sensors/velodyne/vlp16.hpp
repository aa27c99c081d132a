// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The Velodyne VLP-16 as its manual describes it (63-9243 rev. E, chapters 5 and 9): geometry,
// firing times and the layout of a data packet. Used by the reader and by the simulation, so that
// both follow one table.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace surefoot::vlp16 {

inline constexpr int kLasers = 16;
inline constexpr std::size_t kPacketBytes = 1206;
inline constexpr std::size_t kBlocks = 12;
inline constexpr std::size_t kBlockBytes = 100;
inline constexpr std::size_t kChannelsPerBlock = 32;  // two firing sequences of 16 lasers
inline constexpr std::uint16_t kUdpPort = 2368;
inline constexpr double kDistanceUnit = 0.002;       // [m]
inline constexpr int kAzimuthUnitsPerTurn = 36'000;  // 0.01 deg

inline constexpr std::uint8_t kStrongest = 0x37;
inline constexpr std::uint8_t kLast = 0x38;
inline constexpr std::uint8_t kDual = 0x39;
inline constexpr std::uint8_t kProductVlp16 = 0x22;

inline constexpr double kSequenceNs = 55'296.0;  // one firing sequence: 16 lasers and a recharge
inline constexpr double kLaserNs = 2'304.0;

/// Elevation by laser id, in firing order [deg].
inline constexpr std::array<double, kLasers> kElevationDeg = {-15, 1, -13, 3,  -11, 5,  -9, 7,
                                                              -7,  9, -5,  11, -3,  13, -1, 15};
/// Ring (0 = lowest) by laser id.
inline constexpr std::array<std::uint16_t, kLasers> kRing = {0, 8,  1, 9,  2, 10, 3, 11,
                                                             4, 12, 5, 13, 6, 14, 7, 15};
/// Vertical origin offset by laser id [mm], manual table 9-1: -41.91 mm * tan(elevation).
inline constexpr std::array<double, kLasers> kVerticalOffsetMm = {
    11.2, -0.7, 9.7, -2.2, 8.1, -3.7, 6.6, -5.1, 5.1, -6.6, 3.7, -8.1, 2.2, -9.7, 0.7, -11.2};

}  // namespace surefoot::vlp16
