// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "fuzz/targets.hpp"

#include <cstdio>
#include <cstdlib>
#include <memory>

#include "io/ascii_values.hpp"
#include "io/bags/bag_metadata.hpp"
#include "io/bags/compression.hpp"
#include "io/bags/mcap_reader.hpp"
#include "io/bags/ros1_bag_format.hpp"
#include "io/bags/ros1_bag_reader.hpp"
#include "io/file_writer.hpp"
#include "io/files/pcd_writer.hpp"
#include "io/files/ply_writer.hpp"
#include "io/files/scan_files.hpp"
#include "io/messages/cloud_message.hpp"
#include "io/messages/packet_message.hpp"
#include "io/messages/point_cloud2_writer.hpp"
#include "io/packets/capture_recording.hpp"
#include "io/packets/packet_scans.hpp"
#include "io/recording.hpp"
#include "io/scan_builder.hpp"
#include "io/stamps.hpp"
#include "io/trajectory_files.hpp"
#include "io/truth_files.hpp"
#include "sensors/sensor_list.hpp"
#include "sensors/velodyne/vlp16.hpp"
#include "unit/io/support.hpp"
#include "unit/sensors/encoders.hpp"

namespace surefoot::fuzz {
namespace {

using Bytes = std::span<const std::byte>;
using Seeds = std::vector<std::string>;

// Parses a file and goes the whole way to a scan, as a recording does.
void read_scan(io::ScanFileKind kind, Bytes bytes) {
  try {
    const io::PointTable table = io::parse_scan_file(kind, bytes);
    const io::ScanColumns columns = io::find_scan_columns(table, {});
    std::optional<io::PointTimeRule> rule;
    if (columns.time != nullptr) {
      const io::TimeExtents extents = io::time_extents(table, columns);
      rule = io::decide_point_time(extents, columns.time->type, std::nullopt, {});
    }
    (void)io::build_scan(table, columns, rule, std::nullopt, io::StampAt::start);
  } catch (const io::ReadError&) {
  }
}

Scan small_scan() {
  Scan scan;
  for (int i = 0; i < 4; ++i) {
    scan.points.emplace_back(1.0F + static_cast<float>(i), -2.0F, 0.5F);
    scan.intensities.push_back(7.0F);
    scan.times_ns.push_back(i * 25'000'000);
    scan.rings.push_back(static_cast<std::uint16_t>(i));
  }
  return scan;
}

void read_pcd(Bytes bytes) { read_scan(io::ScanFileKind::pcd, bytes); }
Seeds pcd_seeds() {
  using enum io::PcdData;
  const Scan scan = small_scan();
  return {io::format_pcd(scan, ascii), io::format_pcd(scan, binary),
          io::format_pcd(scan, binary_compressed)};
}

void read_ply(Bytes bytes) { read_scan(io::ScanFileKind::ply, bytes); }
Seeds ply_seeds() {
  const Scan scan = small_scan();
  const std::string lists =
      "element face 1\nproperty list uchar int v\nelement vertex 1\nproperty list ushort float "
      "l\nproperty float x\nproperty double y\nproperty int16 z\nproperty uint t\nend_header\n";
  return {io::format_ply(scan.points, scan.intensities, io::PlyFlavour::ascii),
          io::format_ply(scan.points, scan.intensities, io::PlyFlavour::binary),
          "ply\nformat ascii 1.0\n" + lists + "2 0 1\n1 5 1 2 3 4\n",
          "ply\nformat binary_big_endian 1.0\n" + lists + std::string("\1\0\0\0\0\0\0", 7) +
              std::string(18, '\0')};
}

void read_kitti(Bytes bytes) { read_scan(io::ScanFileKind::kitti_bin, bytes); }
Seeds kitti_seeds() { return {std::string(64, '\x3f')}; }

void read_las(Bytes bytes) { read_scan(io::ScanFileKind::las, bytes); }
Seeds las_seeds() {
  Seeds seeds;
  for (const unsigned format : {0U, 1U, 6U}) {
    const unsigned minor = format < 6 ? 2 : 4, header = minor == 4 ? 375 : 227;
    const unsigned record = format == 0 ? 20 : format == 1 ? 28 : 30;
    std::string file(header + 2 * record, '\0');
    const auto put = [&file](std::size_t at, auto value) {
      const std::string bytes = io::test::little(value);
      file.replace(at, bytes.size(), bytes);
    };
    file.replace(0, 4, "LASF");
    file[24] = 1;
    file[25] = static_cast<char>(minor);
    put(96, header);
    file[104] = static_cast<char>(format);
    put(105, static_cast<std::uint16_t>(record));
    put(107, 2U);
    for (std::size_t axis = 0; axis < 3; ++axis) put(131 + 8 * axis, 0.001);
    seeds.push_back(file);
  }
  return seeds;
}

std::string packet(unsigned mode, unsigned azimuth, std::uint32_t time) {
  return io::test::vlp16_payload(azimuth, 40, time, mode, [](auto block, auto channel) {
    return io::test::Measured{static_cast<std::uint16_t>(500 + channel),
                              static_cast<std::uint8_t>(block)};
  });
}

// Payloads of one size one after the other, 1.3 ms apart.
void read_packets(Bytes bytes, std::size_t size, const std::string& sensor = "",
                  const std::string& metadata = "") {
  io::OpenOptions options;
  options.dual_return = io::ReturnChoice::both;
  options.sensor = sensor;
  io::PacketScans scans(options, metadata);
  std::int64_t arrival_ns = 0;
  while (!bytes.empty()) {
    const Bytes payload = bytes.first(std::min(size, bytes.size()));
    scans.add(arrival_ns, payload);
    arrival_ns += 1'327'104;
    bytes = bytes.subspan(payload.size());
  }
  scans.finish();
  while (scans.take()) {
  }
}
void read_vlp16(Bytes bytes) { read_packets(bytes, vlp16::kPacketBytes); }
Seeds vlp16_seeds() {
  return {packet(0x37, 35700, 5) + packet(0x37, 180, 1332), packet(0x39, 35900, 5)};
}

// The other Velodynes, whose packets are as large.
Seeds velodyne_seeds() {
  const std::vector<unsigned> turning = {0, 20, 40, 60, 80, 100, 120, 140, 160, 180, 200, 220};
  using sensors::test::velodyne_packet;
  std::string dual =
      velodyne_packet({0xeeff, 0xeeff, 0xddff, 0xddff, 0xccff, 0xccff, 0xbbff, 0xbbff},
                      std::vector<unsigned>(12, 35'999), 7, 0x39, 0xa1);
  sensors::test::set_velodyne(dual, 3, 5, 1000, 200);
  std::string two_banks = velodyne_packet({0xeeff, 0xddff}, turning, 5, 'V', 1);
  sensors::test::set_velodyne(two_banks, 3, 5, 1000, 200);
  return {dual + dual, two_banks + two_banks,
          velodyne_packet({0xeeff}, turning, 5, 0x37, 0x28) +
              velodyne_packet({0xeeff}, turning, 560, 0x37, 0x28)};
}

// The first byte chooses the model.
void read_hesai(Bytes bytes) {
  const auto& layouts = sensors::test::hesai_layouts();
  if (!bytes.empty()) {
    const auto choice = std::to_integer<std::size_t>(bytes.front()) % layouts.size();
    read_packets(bytes.subspan(1), layouts[choice].size);
  }
}
Seeds hesai_seeds() {
  Seeds seeds;
  for (const sensors::test::HesaiLayout& layout : sensors::test::hesai_layouts()) {
    std::string packets(1, static_cast<char>(seeds.size()));
    for (const std::uint32_t i : {0U, 1U}) {
      std::string one = sensors::test::hesai_packet(layout, 35'900, 20, 2, 0x39, 400 * i, i);
      sensors::test::set_hesai(one, layout, i, 3, 500, 7);
      packets += one;
    }
    seeds.push_back(packets);
  }
  return seeds;
}

struct OusterFormat {
  const char* profile;
  std::size_t pixel_bytes;
  bool legacy;
};
constexpr OusterFormat kOusterFormats[] = {{"LEGACY", 12, true},
                                           {"RNG19_RFL8_SIG16_NIR16", 12, false},
                                           {"RNG19_RFL8_SIG16_NIR16_DUAL", 16, false},
                                           {"RNG15_RFL8_NIR8", 4, false},
                                           {"RNG15_RFL8_NIR8_DUAL", 8, false}};

// The first byte chooses the profile.
void read_ouster(Bytes bytes) {
  if (!bytes.empty()) {
    const OusterFormat& format =
        kOusterFormats[std::to_integer<std::size_t>(bytes.front()) % std::size(kOusterFormats)];
    const std::string packet =
        sensors::test::ouster_packet(format.pixel_bytes, format.legacy, 0, 0, 0);
    read_packets(bytes.subspan(1), packet.size(), "", sensors::test::ouster_json(format.profile));
  }
}
Seeds ouster_seeds() {
  Seeds seeds;
  for (const OusterFormat& format : kOusterFormats) {
    std::string packets(1, static_cast<char>(seeds.size()));
    for (const int i : {0, 1}) {
      std::string one = sensors::test::ouster_packet(format.pixel_bytes, format.legacy, 65'535,
                                                     static_cast<std::uint16_t>(16 * i),
                                                     1'000'000 + 25'000'000ULL * i);
      sensors::test::put(one, sensors::test::ouster_pixel(format.pixel_bytes, format.legacy, 3, 5),
                         std::uint16_t{3000});
      packets += one;
    }
    seeds.push_back(packets);
  }
  return seeds;
}

void read_livox(Bytes bytes) { read_packets(bytes, 36 + 96 * 14); }
Seeds livox_seeds() {
  return {sensors::test::livox_packet(1'000, 1, 14) + sensors::test::livox_packet(481'000, 1, 14),
          sensors::test::livox_packet(1'000, 2, 8), sensors::test::livox_packet(1'000, 3, 10)};
}

void read_rs16(Bytes bytes) { read_packets(bytes, 1248); }
Seeds rs16_seeds() {
  return {sensors::test::rs16_packet(35'900, 40, 5'000) +
          sensors::test::rs16_packet(380, 40, 6'332)};
}

// A calibration or metadata file, tried on a packet of each maker that reads one.
void read_calibration(Bytes bytes) {
  static const std::string packets[] = {
      sensors::test::velodyne_packet({0xeeff}, std::vector<unsigned>(12, 0), 5, 0x37, 0x28),
      sensors::test::hesai_packet(sensors::test::hesai_layouts().front(), 0, 18, 1, 0x37, 0, 0),
      sensors::test::ouster_packet(12, true, 0, 0, 0)};
  sensors::DecoderOptions options;
  options.calibration = std::string(io::text_of(bytes));
  for (const std::string& packet : packets) {
    try {
      std::string reason;
      (void)sensors::find_decoder(io::test::bytes_of(packet), "", options, reason);
    } catch (const sensors::CalibrationError&) {
    }
  }
}
Seeds calibration_seeds() {
  std::string yaml = "lasers:\n";
  std::string csv = "Laser id,Elevation,Azimuth\n";
  for (int id = 0; id < 32; ++id) {
    yaml +=
        "- {laser_id: " + std::to_string(id) + ", rot_correction: 0.1, vert_correction: -0.2}\n";
  }
  for (int id = 1; id <= 16; ++id) {
    csv += std::to_string(id) + "," + std::to_string(16 - 2 * id) + ",0.1\n";
  }
  return {yaml, csv, sensors::test::ouster_json("LEGACY"),
          sensors::test::ouster_json("RNG15_RFL8_NIR8", true)};
}

void read_stream(std::FILE* file) {
  try {
    const auto recording = io::open_capture(file, "capture", {});
    while (recording->next()) {
    }
  } catch (const io::ReadError&) {
  }
}
void read_capture(Bytes bytes) {
  if (bytes.empty()) {
    return;
  }
  std::string content(io::text_of(bytes));
  if (std::FILE* file = fmemopen(content.data(), content.size(), "rb")) {
    read_stream(file);
  }
}
Seeds capture_seeds() {
  Seeds seeds;
  for (const std::uint32_t link_type : {1U, 101U}) {
    io::test::PcapFile file(link_type);
    for (unsigned i = 0; i < 2; ++i) {
      const std::string ip = io::test::ip_packet(packet(0x37, 35700 + 480 * i, 1327 * i), 2368, i);
      file.add(1'000'000'000 + i * 1'327'000,
               link_type == 1 ? io::test::ethernet_frame(ip, i) : ip);
    }
    seeds.push_back(file.content());
  }
  return seeds;
}

void read_text(Bytes bytes) {
  const std::string_view text = io::text_of(bytes);
  const auto attempt = [text](auto&& parse) {
    try {
      (void)parse(text);
    } catch (const io::ReadError&) {
    }
  };
  attempt(io::parse_tum);
  attempt(io::parse_kitti_poses);
  attempt(io::parse_stamps);
  attempt(io::parse_truth_table);
  attempt(io::mercator_scale);
  attempt([](std::string_view record) { return io::pose_of_oxts(record, 1.0); });
  attempt(io::parse_bag_metadata);
}
Seeds text_seeds() {
  return {"# t x y z\n1630577758.569489956 1 2 3 0 0 0 1\n1e9 0 0 0 0.5 0.5 0.5 0.5\n",
          "1 0 0 4 0 1 0 5 0 0 1 6\n",
          "#sec,nsec,x\n1583836591,182590976,5.5,-1,0.25,0,0,0.6,0.8\n",
          "1561000444390857630,1,0,0,3,0,1,0,4,0,0,1,5\n1561000444390857631,1,0,0,3,0,1,0,4,0,0,1,"
          "5\n",
          "49.0 8.0 110 0 0 0 9 9\n",
          "storage_identifier: mcap\nrelative_file_paths:\n  - a_0.mcap\ncompression_mode: FILE\n",
          "2011-09-26 14:30:14.950485851\n",
          "1630577758569489956\n"};
}

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
    const io::ScanColumns columns = io::find_scan_columns(cloud.table, {});
    std::optional<io::PointTimeRule> rule;
    if (columns.time != nullptr) {
      const io::TimeExtents extents = io::time_extents(cloud.table, columns);
      rule = io::decide_point_time(extents, columns.time->type, cloud.stamp_ns, {});
    }
    (void)io::build_scan(cloud.table, columns, rule, cloud.stamp_ns, io::StampAt::end);
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

constexpr Target kTargets[] = {{"pcd", read_pcd, pcd_seeds},
                               {"ply", read_ply, ply_seeds},
                               {"kitti", read_kitti, kitti_seeds},
                               {"las", read_las, las_seeds},
                               {"vlp16", read_vlp16, vlp16_seeds},
                               {"velodyne", read_vlp16, velodyne_seeds},
                               {"hesai", read_hesai, hesai_seeds},
                               {"ouster", read_ouster, ouster_seeds},
                               {"livox", read_livox, livox_seeds},
                               {"rs16", read_rs16, rs16_seeds},
                               {"calibration", read_calibration, calibration_seeds},
                               {"capture", read_capture, capture_seeds},
                               {"text", read_text, text_seeds},
                               {"mcap", read_mcap_bytes, mcap_seeds},
                               {"ros1_bag", read_ros1_bytes, ros1_seeds},
                               {"cloud_message", read_cloud_bytes, cloud_seeds},
                               {"packet_message", read_packet_bytes, packet_seeds}};

}  // namespace

std::span<const Target> targets() { return kTargets; }

}  // namespace surefoot::fuzz
