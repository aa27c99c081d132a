// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Real packets of many sensors against what other decoders made of them: the clouds in nebula's
// test resources, the digests in ouster-sdk's. SUREFOOT_NEBULA and SUREFOOT_OUSTER_SDK name clones
// of tier4/nebula and ouster-lidar/ouster-sdk; without them the tests are skipped.
// SUREFOOT_AGREEMENT names a file that gets a line a sensor (docs/results/agreement.csv).
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <unordered_map>

#include "io/bags/bag_files.hpp"
#include "io/files/pcd_reader.hpp"
#include "io/messages/packet_message.hpp"
#include "io/packets/capture_file.hpp"
#include "io/packets/udp_datagram.hpp"
#include "sensors/ouster/ouster_metadata.hpp"
#include "sensors/rings.hpp"
#include "sensors/sensor_list.hpp"
#include "unit/io/support.hpp"

namespace surefoot::io {
namespace {

namespace fs = std::filesystem;

std::string content_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void write_line(const std::string& line) {
  std::printf("%s\n", line.c_str());
  if (const char* const file = std::getenv("SUREFOOT_AGREEMENT")) {
    std::ofstream(file, std::ios::app) << line << '\n';
  }
}

std::string decimals(double value) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.6f", value);
  return text;
}

/// A return as it is given, and without what the head turned while its block's channels fired one
/// after the other.
struct Decoded {
  Eigen::Vector3d at, unturned;
};
using ByRange = std::unordered_multimap<long, Decoded>;  // [mm]

void add_points(const sensors::Firings& packet, ByRange& decoded) {
  std::size_t next = 0;
  for (const sensors::Firing& firing : packet.firings) {
    for (; next < firing.end; ++next) {
      const sensors::FiringPoint& point = packet.points[next];
      const double turn = firing.turned_deg * point.offset_ns / double(firing.duration_ns);
      const Eigen::AngleAxisd back(turn * M_PI / 180.0, Eigen::Vector3d::UnitZ());
      const Eigen::Vector3d at = point.position.cast<double>();
      decoded.insert({std::lround(1000.0 * at.norm()), {at, back * at}});
    }
  }
}

/// All messages up to the one that was recorded at an instant, or all of the bag.
ByRange decode_bag(const fs::path& bag, std::int64_t upto_ns, std::string& sensor) {
  sensors::DecoderOptions options;
  options.returns = sensors::ReturnChoice::both;
  options.beam_origins = false;  // nebula leaves them out
  std::unique_ptr<sensors::PacketDecoder> decoder;
  sensors::Firings packet;
  std::vector<ByRange> messages;
  bool ended = false;
  const auto source = open_bag(bag);
  while (const std::optional<Message> message = ended ? std::nullopt : source->next()) {
    ByRange& points = messages.emplace_back();
    for_each_packet(*message, [&](const MessagePacket& one) {
      std::string reason;
      if (!decoder) decoder = sensors::find_decoder(one.bytes, "", options, reason);
      ASSERT_NE(decoder, nullptr) << reason;
      if (decoder->decode(one.bytes, packet) == sensors::PacketKind::data) {
        add_points(packet, points);
      }
    });
    ended = message->logged_ns == upto_ns;
  }
  if (decoder) sensor = decoder->sensor();
  ByRange decoded;
  const std::size_t used = ended ? std::min<std::size_t>(3, messages.size()) : messages.size();
  for (std::size_t i = messages.size() - used; i < messages.size(); ++i) decoded.merge(messages[i]);
  return decoded;
}

std::vector<Eigen::Vector3d> points_of(const fs::path& cloud) {
  const std::string file = content_of(cloud);
  const PointTable table = parse_pcd(test::bytes_of(file));
  std::vector<Eigen::Vector3d> points(table.size);
  for (const auto& [name, axis] : {std::pair("x", 0), std::pair("y", 1), std::pair("z", 2)}) {
    for_each_value(*table.find(name), table.size,
                   [&, axis = axis](std::size_t i, auto v) { points[i][axis] = double(v); });
  }
  return points;
}

/// Largest differences of points that were found.
struct Agreement {
  std::size_t points = 0, found = 0;
  double range_m = 0.0, angle_deg = 0.0, unturned_deg = 0.0;
};

double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180.0 / M_PI;
}

Agreement compare(const std::vector<Eigen::Vector3d>& theirs, const ByRange& ours) {
  constexpr double kNearRange = 1e-4;  // [m]
  constexpr double kNearAngle = 0.5;   // [deg]
  constexpr double kElevation = 1e-4;  // [rad]: of the same laser; the head's turn is no matter
  Agreement agreement;
  for (const Eigen::Vector3d& point : theirs) {
    ++agreement.points;
    const double range = point.norm();
    double angle = kNearAngle, unturned = kNearAngle, range_off = 0.0;
    for (long key = std::lround(1000.0 * range) - 1, end = key + 3; key < end; ++key) {
      const auto [first, last] = ours.equal_range(key);
      for (auto it = first; it != last; ++it) {
        const double off = std::abs(it->second.at.norm() - range);
        const double elevation = (it->second.at.z() - point.z()) / range;  // nearly
        if (off > kNearRange || std::abs(elevation) > kElevation) continue;
        unturned = std::min(unturned, angle_between(it->second.unturned, point));
        const double turned = angle_between(it->second.at, point);
        if (turned >= angle) continue;
        angle = turned;
        range_off = off;
      }
    }
    if (angle == kNearAngle) continue;
    ++agreement.found;
    agreement.range_m = std::max(agreement.range_m, range_off);
    agreement.angle_deg = std::max(agreement.angle_deg, angle);
    agreement.unturned_deg = std::max(agreement.unturned_deg, unturned);
  }
  return agreement;
}

/// Nebula lets Velodynes' heads turn on for the lasers of a block, as we do, Hesai's not: there it
/// is taken back.
struct NebulaCase {
  const char* sensor;
  const char* bag;  ///< under its maker's test resources
  const char* cloud;
  double most_deg;
};
constexpr NebulaCase kNebula[] = {
    {"VLP-16", "vlp16/1673400471837873222", "1673400472138016708", 0.41},
    {"VLP-32C", "vlp32/1713492677464078412", "1713492677464078412", 0.15},
    {"VLS-128", "vls128/1614315746471294674", "1585897255376374245", 0.18},
    {"PandarXT-16", "xt16/1732848127890747768", "1732848128093928016", 1e-4},
    {"PandarXT-32", "xt32/1673400677802009732", "1673400678101968885", 1e-4},
    {"PandarXT-32M", "xt32m/1660893203042895158", "1660893203292679064", 1e-4},
    {"PandarQT64", "qt64/1673401195788312575", "1673401196087570870", 1e-4},
    {"PandarQT128", "qt128/1730273789074637152", "1730273789174759609", 1e-4},
    {"Pandar40P", "40p/1673400149412331409", "1673400149711850138", 1e-4},
    {"Pandar64", "64/1673403880599376836", "1673403880898440686", 1e-4}};

TEST(DecoderAgreement, Nebula) {
  const char* const clone = std::getenv("SUREFOOT_NEBULA");
  if (clone == nullptr) GTEST_SKIP() << "SUREFOOT_NEBULA names no folder";
  for (const NebulaCase& one : kNebula) {
    const bool hesai = std::string_view(one.sensor).starts_with("Pandar");
    const std::string maker = hesai ? "nebula_hesai" : "nebula_velodyne";
    const fs::path bag = fs::path(clone) / "src" / maker / maker / "test_resources" /
                         "decoder_ground_truth" / one.bag;
    std::string sensor;
    const ByRange ours = decode_bag(bag, std::atoll(one.cloud), sensor);
    EXPECT_EQ(sensor, one.sensor);
    const std::string cloud = std::string(one.cloud) + ".pcd";
    const Agreement is = compare(points_of(bag.parent_path() / cloud), ours);
    EXPECT_GT(is.points, 10'000U) << one.sensor;
    EXPECT_EQ(is.found, is.points) << one.sensor;
    EXPECT_LT(is.range_m, 4e-5) << one.sensor;
    EXPECT_LT(hesai ? is.unturned_deg : is.angle_deg, one.most_deg) << one.sensor;
    write_line(sensor + ",nebula," + std::to_string(is.points) + ',' + std::to_string(is.found) +
               ',' + decimals(is.range_m) + ',' + decimals(is.angle_deg) + ',' +
               (hesai ? decimals(is.unturned_deg) : "") + ",not given");
  }
}

/// The payloads of all datagrams, put together.
std::vector<std::string> payloads_of(const fs::path& capture) {
  std::vector<std::string> payloads;
  CaptureFile file(capture);
  FragmentBuffer fragments;
  while (const std::optional<CapturedFrame> frame = file.next()) {
    IpFragment fragment;
    UdpDatagram datagram = find_udp(file.link(), frame->bytes, &fragment);
    if (datagram.content == FrameContent::fragment) datagram = fragments.add(fragment);
    if (datagram.content != FrameContent::udp) continue;
    const auto* const begin = reinterpret_cast<const char*>(datagram.payload.data());
    payloads.emplace_back(begin, datagram.payload.size());
  }
  return payloads;
}

/// What a frame's digest is of: stamps of columns, ranges of pixels.
struct OusterFrame {
  std::vector<std::uint64_t> stamps;
  std::vector<std::uint32_t> ranges;
  std::size_t points = 0;
};

/// Points back to ranges, as the sensor gives them.
class RangeImage {
 public:
  explicit RangeImage(const std::string& json)
      : metadata_(sensors::parse_ouster_metadata(json)),
        rings_(sensors::rings_of(metadata_.elevation_deg)) {}

  void add(const sensors::Firings& packet, std::map<std::uint32_t, OusterFrame>& frames) const {
    const std::size_t columns = metadata_.columns_per_frame;
    std::size_t next = 0;
    for (const sensors::Firing& firing : packet.firings) {
      OusterFrame& frame = frames[firing.frame];
      frame.stamps.resize(columns);
      frame.ranges.resize(columns * metadata_.pixels);
      const auto column = static_cast<std::size_t>(
          std::lround(firing.azimuth_deg / 360.0 * static_cast<double>(columns)));
      frame.stamps[column] = static_cast<std::uint64_t>(packet.time_ns + firing.offset_ns);
      for (; next < firing.end; ++next) {
        const sensors::FiringPoint& point = packet.points[next];
        const auto row = std::find(rings_.begin(), rings_.end(), point.ring) - rings_.begin();
        frame.ranges[static_cast<std::size_t>(row) * columns + column] =
            range_mm(point.position.cast<double>(), firing.azimuth_deg);
        ++frame.points;
      }
    }
  }
  [[nodiscard]] const sensors::OusterMetadata& metadata() const { return metadata_; }

 private:
  [[nodiscard]] std::uint32_t range_mm(const Eigen::Vector3d& position, double azimuth_deg) const {
    const Eigen::Matrix4d& to_sensor = metadata_.T_sensor_lidar;
    const Eigen::Vector3d lidar =
        to_sensor.topLeftCorner<3, 3>().transpose() * (position - to_sensor.topRightCorner<3, 1>());
    const Eigen::Vector2d origin(metadata_.T_lidar_beam(0, 3), metadata_.T_lidar_beam(2, 3));
    const double encoder = -azimuth_deg * M_PI / 180.0;
    const Eigen::Vector3d from(origin.x() * std::cos(encoder), origin.x() * std::sin(encoder),
                               origin.y());
    const double to_origin = origin.y() == 0.0 ? origin.x() : origin.norm();
    return static_cast<std::uint32_t>(std::lround(1000.0 * ((lidar - from).norm() + to_origin)));
  }

  sensors::OusterMetadata metadata_;
  std::vector<std::uint16_t> rings_;
};

template <typename T>
std::string md5_of(const std::vector<T>& values, const test::TemporaryFolder& folder) {
  const fs::path file = folder.write(
      "bytes", {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)});
  std::FILE* const pipe = popen(("md5sum '" + file.string() + "'").c_str(), "r");
  char text[33] = {};
  const std::size_t got = pipe == nullptr ? 0 : std::fread(text, 1, 32, pipe);
  if (pipe != nullptr) pclose(pipe);
  return {text, got};
}

TEST(DecoderAgreement, Ouster) {
  const char* const clone = std::getenv("SUREFOOT_OUSTER_SDK");
  if (clone == nullptr) GTEST_SKIP() << "SUREFOOT_OUSTER_SDK names no folder";
  const fs::path folder = fs::path(clone) / "tests" / "pcaps";
  const test::TemporaryFolder scratch;
  for (const char* name :
       {"OS-0-128-U1_v2.3.0_1024x10", "OS-0-32-U1_v2.2.0_1024x10", "OS-1-32-G_v2.1.1_1024x10",
        "OS-2-32-U0_v2.0.0_1024x10", "OS-2-128-U1_v2.3.0_1024x10"}) {
    const std::string stem = (folder / name).string();
    sensors::DecoderOptions options;
    options.metadata = content_of(stem + ".json");
    const RangeImage image(options.metadata);
    std::unique_ptr<sensors::PacketDecoder> decoder;
    sensors::Firings packet;
    std::map<std::uint32_t, OusterFrame> frames;
    for (const std::string& payload : payloads_of(stem + ".pcap")) {
      std::string reason;
      const auto bytes = test::bytes_of(payload);
      if (!decoder) decoder = sensors::find_decoder(bytes, "", options, reason);
      if (!decoder || decoder->decode(bytes, packet) != sensors::PacketKind::data) continue;
      image.add(packet, frames);
    }
    ASSERT_NE(decoder, nullptr) << name;
    const nlohmann::json digest = nlohmann::json::parse(content_of(stem + "_digest.json"));
    for (const nlohmann::json& frame : digest["scans"]) {
      const auto id = static_cast<std::uint32_t>(std::stoul(frame["FRAME_ID"].get<std::string>()));
      ASSERT_EQ(frames.count(id), 1U) << name;
      const OusterFrame& ours = frames[id];
      EXPECT_EQ(md5_of(ours.stamps, scratch), frame["TIMESTAMP"]) << name;
      const bool dual = image.metadata().profile.is_dual();  // whose equal returns are kept once
      if (!dual) {
        EXPECT_EQ(md5_of(ours.ranges, scratch), frame["RANGE"]) << name;
      }
      write_line(decoder->sensor() + ' ' + image.metadata().profile.name + ",ouster-sdk," +
                 std::to_string(ours.points) + ',' +
                 (dual ? ",,,," : std::to_string(ours.points) + ",0.000000,,,") + "equal");
    }
  }
}

}  // namespace
}  // namespace surefoot::io
