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

#include <Eigen/Geometry>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <tuple>

#include "io/files/pcd_reader.hpp"
#include "sensors/sensor_list.hpp"
#include "unit/io/support.hpp"

namespace surefoot::io {
namespace {

const std::filesystem::path kFolder =
    std::filesystem::path(SUREFOOT_SHARED_DATA) / "vlp16_dual_nebula";

// A CDR message: header, then packets of {stamp, `room` bytes}, and their size where `sized`.
std::vector<std::string> payloads_of_message(const std::string& database, const char* stamp,
                                             std::size_t room = 1206, bool sized = false) {
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
    for (at += 4; count > 0; --count) {
      const std::size_t end = aligned(at + 8 + room);
      payloads.push_back(data.substr(at + 8, sized ? u32(end) : room));
      at = sized ? end + 4 : end;
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

std::multimap<Key, Decoded> decode_all(const std::vector<std::string>& payloads) {
  sensors::DecoderOptions options;
  options.returns = sensors::ReturnChoice::both;
  options.beam_origins = false;
  std::string reason;
  const auto decoder = sensors::find_decoder(test::bytes_of(payloads.front()), "", options, reason);
  sensors::Firings packet;
  std::multimap<Key, Decoded> decoded;
  for (const std::string& payload : payloads) {
    EXPECT_EQ(decoder->decode(test::bytes_of(payload), packet), sensors::PacketKind::data);
    EXPECT_EQ(decoder->return_mode(), "dual");
    std::size_t next = 0;
    for (std::size_t i = 0; i < packet.firings.size(); ++i) {
      for (; next < packet.firings[i].end; ++next) {
        const sensors::FiringPoint& point = packet.points[next];
        const Eigen::Vector3d at = point.position.cast<double>();
        const Decoded firing{std::atan2(-at.y(), at.x()) * 180.0 / M_PI,
                             packet.firings[i / 2 * 2].azimuth_deg,
                             packet.firings[i].offset_ns + point.offset_ns, i / 2};
        decoded.insert(
            {{point.ring, int(std::lround(500.0 * at.norm())), int(point.intensity)}, firing});
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
  const std::multimap<Key, Decoded> decoded = decode_all(payloads);

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

// The same for a Hesai XT-16. Nebula leaves out how far the head turns while the channels of a
// block fire one after the other; with that taken back all points are where nebula has them.
TEST(HesaiXt16, AgreesWithAnotherDecoder) {
  const std::filesystem::path folder =
      std::filesystem::path(SUREFOOT_SHARED_DATA) / "hesai_xt16_nebula";
  if (!std::filesystem::exists(folder)) {
    GTEST_SKIP() << folder << " is absent";
  }
  const std::string bag = (folder / "1732848127890747768/1732848127890747768_0.db3").string();
  sensors::DecoderOptions options;
  options.returns = sensors::ReturnChoice::both;
  std::unique_ptr<sensors::PacketDecoder> decoder;
  sensors::Firings packet;
  std::multimap<long, Eigen::Vector3d> decoded;  // by range [mm]
  std::string reason;
  for (const char* stamp : {"1732848127993428577", "1732848128093928016"}) {
    for (const std::string& payload : payloads_of_message(bag, stamp, 1500, true)) {
      if (!decoder) decoder = sensors::find_decoder(test::bytes_of(payload), "", options, reason);
      ASSERT_NE(decoder, nullptr) << reason;
      ASSERT_EQ(decoder->decode(test::bytes_of(payload), packet), sensors::PacketKind::data);
      std::size_t next = 0;
      for (const sensors::Firing& firing : packet.firings) {
        for (; next < firing.end; ++next) {
          const sensors::FiringPoint& point = packet.points[next];
          const double turn = firing.turned_deg * point.offset_ns / double(firing.duration_ns);
          const Eigen::AngleAxisd back(turn * M_PI / 180.0, Eigen::Vector3d::UnitZ());
          const Eigen::Vector3d at = back * point.position.cast<double>();
          decoded.insert({std::lround(1000.0 * at.norm()), at});
        }
      }
    }
  }
  EXPECT_EQ(decoder->sensor(), "PandarXT-16");
  EXPECT_EQ(decoder->return_mode(), "dual, last and strongest");

  std::ifstream stream(folder / "1732848128093928016.pcd", std::ios::binary);
  const std::string file((std::istreambuf_iterator<char>(stream)), {});
  const PointTable table = parse_pcd(test::bytes_of(file));
  std::vector<Eigen::Vector3d> reference(table.size);
  for (const auto& [name, axis] : {std::pair("x", 0), std::pair("y", 1), std::pair("z", 2)}) {
    for_each_value(*table.find(name), table.size,
                   [&, axis = axis](std::size_t i, auto v) { reference[i][axis] = double(v); });
  }
  ASSERT_EQ(reference.size(), 26287U);
  std::size_t missing = 0;
  for (const Eigen::Vector3d& point : reference) {
    const long range = std::lround(1000.0 * point.norm());
    bool found = false;
    for (auto it = decoded.lower_bound(range - 1); it != decoded.upper_bound(range + 1); ++it) {
      found = found || (it->second - point).norm() < 1e-4;
    }
    missing += found ? 0 : 1;
  }
  EXPECT_EQ(missing, 0U);
}

}  // namespace
}  // namespace surefoot::io
