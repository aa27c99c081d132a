// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "fuzz/targets.hpp"

#include <sqlite3.h>

#include <cstdlib>
#include <memory>

#include "fuzz/whole_way.hpp"
#include "io/bags/compression.hpp"
#include "io/bags/mcap_reader.hpp"
#include "io/bags/ros1_bag_format.hpp"
#include "io/bags/ros1_bag_reader.hpp"
#include "io/bags/sqlite_bag_reader.hpp"
#include "io/file_writer.hpp"
#include "io/messages/cloud_message.hpp"
#include "io/messages/motion_message.hpp"
#include "io/messages/packet_message.hpp"
#include "io/messages/point_cloud2_writer.hpp"
#include "io/messages/pose_messages.hpp"
#include "unit/io/support.hpp"

namespace surefoot::fuzz {
namespace {

// Every message to its end.
template <typename Read>
void read_bag(Bytes bytes, Read&& open) {
  try {
    const auto bag = open(std::make_unique<io::MemoryStream>(bytes));
    while (bag->next()) {
    }
  } catch (const io::ReadError&) {
  }
}

void append_record(std::string& out, char opcode, const std::string& body) {
  out += opcode;
  io::append_bytes(out, std::uint64_t{body.size()});
  out += body;
}
std::string sized(const std::string& bytes) {
  std::string out;
  io::append_bytes(out, static_cast<std::uint32_t>(bytes.size()));
  return out + bytes;
}

void read_mcap_bytes(Bytes bytes) { read_bag(bytes, io::read_mcap); }
Seeds mcap_seeds() {
  using io::test::little;
  std::string inside;
  append_record(inside, 3, little(std::uint16_t{1}) + sized("p/T") + sized("ros2msg") + sized("x"));
  append_record(
      inside, 4,
      little(std::uint16_t{1}) + little(std::uint16_t{1}) + sized("/t") + sized("cdr") + sized(""));
  append_record(inside, 5, little(std::uint16_t{1}) + std::string(20, '\1') + "message");
  Seeds seeds;
  for (const char* name : {"", "lz4", "zstd"}) {
    const std::string records = io::compress(*io::compression_named(name), inside);
    std::string file = "\x89MCAP0\r\n";
    append_record(file, 1, sized("ros2") + sized(""));
    append_record(file, 6,
                  std::string(16, '\0') + little(std::uint64_t{inside.size()}) + little(0U) +
                      sized(name) + little(std::uint64_t{records.size()}) + records);
    append_record(file, 15, little(0U));
    seeds.push_back(file);
  }
  return seeds;
}

// sqlite3 reads files alone: one that is in memory.
void read_sqlite_bytes(Bytes bytes) {
  static const MemoryFile file;
  try {
    const auto bag = io::read_sqlite_bag(file.holding(bytes));
    while (bag->next()) {
    }
  } catch (const io::ReadError&) {
  }
}
Seeds sqlite_seeds() {
  sqlite3* database = nullptr;
  sqlite3_open(":memory:", &database);
  const std::string compressed = io::compress(io::Compression::zstd, "a message");
  const char* const rows =
      "PRAGMA page_size=512;"
      "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT, type TEXT, serialization_format "
      "TEXT);"
      "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER, timestamp INTEGER, data "
      "BLOB);"
      "INSERT INTO topics VALUES (1, '/t', 'p/msg/T', 'cdr'), (2, '/u', 'p/msg/U', 'ros1');"
      "INSERT INTO messages VALUES (1, 1, 5, 'message'), (2, 2, 6, zeroblob(900)), (4, 3, 7, 'x');";
  sqlite3_exec(database, rows, nullptr, nullptr, nullptr);
  sqlite3_stmt* insert = nullptr;
  sqlite3_prepare_v2(database, "INSERT INTO messages VALUES (9, 1, 8, ?)", -1, &insert, nullptr);
  sqlite3_bind_blob(insert, 1, compressed.data(), static_cast<int>(compressed.size()), nullptr);
  sqlite3_step(insert);
  sqlite3_finalize(insert);
  sqlite3_int64 size = 0;
  unsigned char* const image = sqlite3_serialize(database, "main", &size, 0);
  const std::string file(reinterpret_cast<const char*>(image), static_cast<std::size_t>(size));
  sqlite3_free(image);
  sqlite3_close(database);
  return {file, io::compress(io::Compression::zstd, file)};
}

void read_ros1_bytes(Bytes bytes) { read_bag(bytes, io::read_ros1_bag); }
std::string ros1_record(const Seeds& fields, const std::string& data) {
  std::string header;
  for (const std::string& field : fields) header += sized(field);
  return sized(header) + sized(data);
}
Seeds ros1_seeds() {
  const std::string id = "conn=" + std::string(4, '\0');
  const std::string inside = ros1_record({"op=\7", id, "topic=/t"}, sized("type=p/T")) +
                             ros1_record({"op=\2", id, "time=" + std::string(8, '\1')}, "message");
  const std::string bzip2 =
      std::string("\x42\x5a\x68\x39\x17\x72\x45\x38\x50\x90\x00\x00\x00\x00", 14);  // of nothing
  Seeds seeds;
  for (const std::string name : {"none", "lz4", "bz2"}) {
    const std::string data = name == "lz4"   ? io::compress(io::Compression::lz4, inside)
                             : name == "bz2" ? bzip2
                                             : inside;
    seeds.push_back(std::string(io::kRos1BagMagic) + ros1_record({"op=\3"}, std::string(20, ' ')) +
                    ros1_record({"op=\5", "compression=" + name, "size=1234"}, data));
  }
  return seeds;
}

// The first byte chooses type and encoding; then the whole way to a scan.
void read_cloud_bytes(Bytes bytes) {
  if (bytes.empty()) return;
  const auto choice = std::to_integer<unsigned>(bytes[0]);
  const char* const type =
      choice % 2 == 0 ? "sensor_msgs/PointCloud2" : "livox_ros_driver2/CustomMsg";
  const auto encoding = choice / 2 % 2 == 0 ? io::MessageEncoding::cdr : io::MessageEncoding::ros1;
  try {
    const io::CloudMessage cloud = io::read_cloud(type, encoding, bytes.subspan(1));
    go_on_to_a_scan(cloud.table, cloud.stamp_ns, io::StampAt::end);
  } catch (const io::ReadError&) {
  }
}
Seeds cloud_seeds() {
  using Flavour = io::MessageWriter::Flavour;
  const Scan scan = small_scan();
  io::MessageWriter livox;
  livox.header(5, "l").number(std::uint64_t{5}).number(1U).number(0U).count(1);
  livox.number(7U).number(1.0F).number(2.0F).number(3.0F).raw("abc");
  return {std::string(1, '\0') + io::format_point_cloud2(scan, "f", Flavour::cdr),
          std::string(1, '\2') + io::format_point_cloud2(scan, "f", Flavour::ros1),
          std::string(1, '\1') + livox.take()};
}

void read_packet_bytes(Bytes bytes) {
  if (bytes.empty()) return;
  constexpr const char* kTypes[] = {"velodyne_msgs/VelodyneScan", "pandar_msgs/PandarScan",
                                    "hesai_ros_driver/UdpFrame", "nebula_msgs/NebulaPackets",
                                    "ouster_ros/PacketMsg"};
  const auto choice = std::to_integer<unsigned>(bytes[0]);
  const io::Topic topic{"/t", kTypes[choice / 2 % 5],
                        choice % 2 == 0 ? io::MessageEncoding::cdr : io::MessageEncoding::ros1};
  std::size_t total = 0;
  try {
    io::for_each_packet({&topic, 0, bytes.subspan(1)},
                        [&](const io::MessagePacket& packet) { total += packet.bytes.size(); });
  } catch (const io::ReadError&) {
  }
  if (total > bytes.size()) std::abort();
}
Seeds packet_seeds() {
  io::MessageWriter nebula;
  nebula.header(5, "l").count(2);
  for (int i = 0; i < 2; ++i) nebula.time(7).count(3).raw("abc");
  return {std::string(1, '\6') + nebula.take(), std::string(1, '\11') + sized("abc")};
}

// The first byte chooses type and encoding.
void read_motion_bytes(Bytes bytes) {
  if (bytes.empty()) return;
  constexpr const char* kTypes[] = {"sensor_msgs/Imu", "nav_msgs/Odometry",
                                    "geometry_msgs/PoseStamped", "geometry_msgs/PointStamped"};
  const auto choice = std::to_integer<unsigned>(bytes[0]);
  const io::Topic topic{"/t", kTypes[choice / 2 % 4],
                        choice % 2 == 0 ? io::MessageEncoding::cdr : io::MessageEncoding::ros1};
  const io::Message message{&topic, 0, bytes.subspan(1)};
  try {
    if (io::is_pose_type(topic.type)) {
      if (!io::read_pose(message).pose.pose.translation.allFinite()) std::abort();
    } else {
      (void)io::read_imu(message);
    }
  } catch (const io::ReadError&) {
  }
}
Seeds motion_seeds() {
  using Flavour = io::MessageWriter::Flavour;
  io::MessageWriter imu(Flavour::ros1);
  imu.header(5, "l");
  for (int i = 0; i < 37; ++i) imu.number(0.5);
  return {std::string(1, '\1') + imu.take(),
          std::string(1, '\2') + io::format_odometry({}, Flavour::cdr),
          std::string(1, '\3') + io::format_odometry({}, Flavour::ros1)};
}

constexpr Target kBagTargets[] = {{"mcap", read_mcap_bytes, mcap_seeds},
                                  {"sqlite_bag", read_sqlite_bytes, sqlite_seeds},
                                  {"ros1_bag", read_ros1_bytes, ros1_seeds},
                                  {"cloud_message", read_cloud_bytes, cloud_seeds},
                                  {"packet_message", read_packet_bytes, packet_seeds},
                                  {"motion_message", read_motion_bytes, motion_seeds}};

}  // namespace

std::span<const Target> bag_targets() { return kBagTargets; }

}  // namespace surefoot::fuzz
