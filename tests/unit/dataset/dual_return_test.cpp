// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Dual-return packets of a real VLP-16 (a rosbag2 with VelodyneScan messages) against the same turn
// decoded by tier4/nebula. Nebula differs in four ways that the comparison allows for: azimuths
// have steps of 0.01 deg; those of a packet's last blocks are not interpolated; those of the nearer
// of two different returns (188 points) are up to a block's step ahead, and left out here; times
// count from the point's own packet, and go on from block to block as if each had firings of its
// own, twice as fast as the sensor's clock (packets are 663.552 us apart).
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <tuple>

#include "dataset/pcd_reader.hpp"
#include "dataset/vlp16_packet.hpp"
#include "dataset/vlp16_revolutions.hpp"
#include "support.hpp"

namespace surefoot::dataset {
namespace {

const std::filesystem::path kFolder =
    std::filesystem::path(SUREFOOT_SHARED_DATA) / "vlp16_dual_nebula";

// The payloads of the message that was decoded, in CDR: header, then {stamp, 1206 bytes} each.
std::vector<std::string> payloads_of_message(const std::string& database, const char* stamp) {
  std::vector<std::string> payloads;
  sqlite3* handle = nullptr;
  sqlite3_stmt* row = nullptr;
  sqlite3_open_v2(("file:" + database + "?immutable=1").c_str(), &handle,
                  SQLITE_OPEN_READONLY | SQLITE_OPEN_URI, nullptr);
  const std::string query = std::string("select data from messages where timestamp=") + stamp;
  if (sqlite3_prepare_v2(handle, query.c_str(), -1, &row, nullptr) == SQLITE_OK &&
      sqlite3_step(row) == SQLITE_ROW) {
    const std::string data(static_cast<const char*>(sqlite3_column_blob(row, 0)),
                           static_cast<std::size_t>(sqlite3_column_bytes(row, 0)));
    const auto u32 = [&](std::size_t at) {
      return load<std::uint32_t>(test::bytes_of(data).data() + at, false);
    };
    const auto aligned = [](std::size_t at) { return (at + 3) / 4 * 4; };
    std::size_t at = aligned(16 + u32(12));
    std::size_t count = u32(at);
    for (at += 4; count > 0; --count, at = aligned(at + 8 + 1206)) {
      payloads.push_back(data.substr(at + 8, 1206));
    }
  }
  sqlite3_finalize(row);
  sqlite3_close(handle);
  return payloads;
}

struct Decoded {
  double azimuth_deg;
  double block_azimuth_deg;
  std::int64_t in_packet_ns;
  std::size_t pair;  ///< of blocks
};
// By ring, distance [2 mm] and reflectivity.
using Key = std::tuple<int, int, int>;

std::multimap<Key, Decoded> decode(const std::vector<std::string>& payloads) {
  std::multimap<Key, Decoded> decoded;
  for (const std::string& payload : payloads) {
    const Vlp16Packet packet = parse_vlp16_packet(test::bytes_of(payload)).value();
    EXPECT_TRUE(packet.is_dual());
    for (std::size_t i = 0; i < packet.sequences(); ++i) {
      const Vlp16Sequence sequence = packet.sequence(i, 10.0);
      for (std::size_t laser = 0; laser < 16; ++laser) {
        const double azimuth =
            0.01 * (sequence.azimuth + sequence.azimuth_step * 2.304 * double(laser) / 55.296);
        const Decoded firing{azimuth, 0.01 * packet.azimuths[i / 2 * 2],
                             sequence.offset_ns + std::int64_t(laser) * 2304, i / 2};
        for (const Vlp16Return& one : {sequence.first[laser], sequence.second[laser]}) {
          decoded.insert({{vlp16::kRing[laser], one.distance, one.reflectivity}, firing});
        }
      }
    }
  }
  return decoded;
}

TEST(DualReturn, AgreesWithAnotherDecoder) {
  if (!std::filesystem::exists(kFolder)) {
    GTEST_SKIP() << kFolder << " is absent";
  }
  // The turn begins in the last packets of the message before.
  const std::string bag = (kFolder / "1673400471837873222/1673400471837873222_0.db3").string();
  std::vector<std::string> payloads = payloads_of_message(bag, "1673400472038371929");
  ASSERT_EQ(payloads.size(), 151U);
  payloads.erase(payloads.begin(), payloads.end() - 2);
  for (std::string& payload : payloads_of_message(bag, "1673400472138016708")) {
    payloads.push_back(std::move(payload));
  }
  ASSERT_EQ(payloads.size(), 152U);
  const std::multimap<Key, Decoded> decoded = decode(payloads);

  std::ifstream stream(kFolder / "1673400472138016708.pcd", std::ios::binary);
  const std::string file((std::istreambuf_iterator<char>(stream)), {});
  const PointTable table = parse_pcd(test::bytes_of(file));
  std::map<std::string, std::vector<double>> reference;
  for (const char* name : {"x", "y", "z", "channel", "distance", "intensity", "azimuth",
                           "time_stamp", "return_type"}) {
    for_each_value(*table.find(name), table.size,
                   [&](std::size_t, auto v) { reference[name].push_back(double(v)); });
  }

  ASSERT_EQ(table.size, 14831U);
  std::size_t compared = 0;
  std::size_t same_place = 0;
  std::size_t same_time = 0;
  for (std::size_t i = 0; i < table.size; ++i) {
    constexpr double kLastWeak = 5;  // as nebula numbers returns
    constexpr double kLastStrongest = 10;
    const double type = reference["return_type"][i];
    if (type == kLastWeak || type == kLastStrongest) {
      continue;
    }
    ++compared;
    const Key key{int(reference["channel"][i]), int(std::lround(500.0 * reference["distance"][i])),
                  int(reference["intensity"][i])};
    const double azimuth_deg = reference["azimuth"][i] * 180.0 / M_PI;
    bool place = false;
    bool time = false;
    const auto [first, last] = decoded.equal_range(key);
    for (auto it = first; it != last; ++it) {
      constexpr std::size_t kLastPair = 5;
      const double ours =
          it->second.pair == kLastPair ? it->second.block_azimuth_deg : it->second.azimuth_deg;
      const double difference = std::remainder(ours - azimuth_deg, 360.0);
      if (std::abs(difference) < 0.0101) {
        place = true;
        const auto by_nebula = it->second.in_packet_ns + 110'592 * std::int64_t(it->second.pair);
        time = time || std::abs(reference["time_stamp"][i] - double(by_nebula)) <= 1.0;
      }
    }
    same_place += place ? 1 : 0;
    same_time += time ? 1 : 0;
    const double horizontal = std::hypot(reference["x"][i], reference["y"][i]);
    // The axes: y = -d cos(el) sin(azimuth).
    EXPECT_NEAR(reference["y"][i], -horizontal * std::sin(reference["azimuth"][i]), 1e-3);
  }
  std::printf("of %zu points %zu agree in ring, distance, reflectivity and azimuth, %zu in time\n",
              compared, same_place, same_time);
  EXPECT_EQ(compared, 14643U);
  EXPECT_GE(same_place, compared * 998 / 1000);
  EXPECT_GE(same_time, compared * 99 / 100);  // a few stand in the packets before the turn
}

}  // namespace
}  // namespace surefoot::dataset
