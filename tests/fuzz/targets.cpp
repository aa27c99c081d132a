// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "fuzz/targets.hpp"

#include <cstdio>
#include <memory>

#include "dataset/ascii_values.hpp"
#include "dataset/capture_recording.hpp"
#include "dataset/pcd_writer.hpp"
#include "dataset/ply_writer.hpp"
#include "dataset/recording.hpp"
#include "dataset/scan_builder.hpp"
#include "dataset/scan_files.hpp"
#include "dataset/stamps.hpp"
#include "dataset/trajectory_files.hpp"
#include "dataset/vlp16_revolutions.hpp"
#include "unit/dataset/support.hpp"

namespace surefoot::fuzz {
namespace {

using Bytes = std::span<const std::byte>;
using Seeds = std::vector<std::string>;

// Parses a file and goes the whole way to a scan, as a recording does.
void read_scan(dataset::ScanFileKind kind, Bytes bytes) {
  try {
    const dataset::PointTable table = dataset::parse_scan_file(kind, bytes);
    const dataset::ScanColumns columns = dataset::find_scan_columns(table, {});
    std::optional<dataset::PointTimeRule> rule;
    if (columns.time != nullptr) {
      const dataset::TimeExtents extents = dataset::time_extents(table, columns);
      rule = dataset::decide_point_time(extents, columns.time->type, std::nullopt, {});
    }
    (void)dataset::build_scan(table, columns, rule, std::nullopt, dataset::StampAt::kStart);
  } catch (const dataset::ReadError&) {
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

void read_pcd(Bytes bytes) { read_scan(dataset::ScanFileKind::kPcd, bytes); }
Seeds pcd_seeds() {
  using enum dataset::PcdData;
  const Scan scan = small_scan();
  return {dataset::format_pcd(scan, kAscii), dataset::format_pcd(scan, kBinary),
          dataset::format_pcd(scan, kBinaryCompressed)};
}

void read_ply(Bytes bytes) { read_scan(dataset::ScanFileKind::kPly, bytes); }
Seeds ply_seeds() {
  const Scan scan = small_scan();
  const std::string lists =
      "element face 1\nproperty list uchar int v\nelement vertex 1\nproperty list ushort float "
      "l\nproperty float x\nproperty double y\nproperty int16 z\nproperty uint t\nend_header\n";
  return {dataset::format_ply(scan.points, scan.intensities, dataset::PlyFlavour::kAscii),
          dataset::format_ply(scan.points, scan.intensities, dataset::PlyFlavour::kBinary),
          "ply\nformat ascii 1.0\n" + lists + "2 0 1\n1 5 1 2 3 4\n",
          "ply\nformat binary_big_endian 1.0\n" + lists + std::string("\1\0\0\0\0\0\0", 7) +
              std::string(18, '\0')};
}

void read_kitti(Bytes bytes) { read_scan(dataset::ScanFileKind::kKittiBin, bytes); }
Seeds kitti_seeds() { return {std::string(64, '\x3f')}; }

std::string packet(unsigned mode, unsigned azimuth, std::uint32_t time) {
  return dataset::test::vlp16_payload(azimuth, 40, time, mode, [](auto block, auto channel) {
    return dataset::test::Measured{static_cast<std::uint16_t>(500 + channel),
                                   static_cast<std::uint8_t>(block)};
  });
}

// Payloads of 1206 bytes one after the other, 1.3 ms apart.
void read_vlp16(Bytes bytes) {
  dataset::OpenOptions options;
  options.dual_return = dataset::ReturnChoice::kBoth;
  dataset::Vlp16Revolutions revolutions(options);
  std::int64_t stamp_ns = 0;
  while (!bytes.empty()) {
    const Bytes payload = bytes.first(std::min(vlp16::kPacketBytes, bytes.size()));
    if (const auto parsed = dataset::parse_vlp16_packet(payload)) {
      revolutions.add(*parsed, stamp_ns, 1'327'104);
      stamp_ns += 1'327'104;
    }
    bytes = bytes.subspan(payload.size());
  }
  revolutions.finish();
  while (revolutions.take()) {
  }
}
Seeds vlp16_seeds() {
  return {packet(0x37, 35700, 5) + packet(0x37, 180, 1332), packet(0x39, 35900, 5)};
}

void read_stream(std::FILE* file) {
  try {
    const auto recording = dataset::open_capture(file, "capture", {});
    while (recording->next()) {
    }
  } catch (const dataset::ReadError&) {
  }
}
void read_capture(Bytes bytes) {
  if (bytes.empty()) {
    return;
  }
  std::string content(dataset::text_of(bytes));
  if (std::FILE* file = fmemopen(content.data(), content.size(), "rb")) {
    read_stream(file);
  }
}
Seeds capture_seeds() {
  Seeds seeds;
  for (const std::uint32_t link_type : {1U, 101U}) {
    dataset::test::PcapFile file(link_type);
    for (unsigned i = 0; i < 2; ++i) {
      const std::string ip =
          dataset::test::ip_packet(packet(0x37, 35700 + 480 * i, 1327 * i), 2368, i);
      file.add(1'000'000'000 + i * 1'327'000,
               link_type == 1 ? dataset::test::ethernet_frame(ip, i) : ip);
    }
    seeds.push_back(file.content());
  }
  return seeds;
}

void read_text(Bytes bytes) {
  const std::string_view text = dataset::text_of(bytes);
  const auto attempt = [text](auto&& parse) {
    try {
      (void)parse(text);
    } catch (const dataset::ReadError&) {
    }
  };
  attempt(dataset::parse_tum);
  attempt(dataset::parse_kitti_poses);
  attempt(dataset::parse_stamps);
}
Seeds text_seeds() {
  return {"# t x y z\n1630577758.569489956 1 2 3 0 0 0 1\n1e9 0 0 0 0.5 0.5 0.5 0.5\n",
          "1 0 0 4 0 1 0 5 0 0 1 6\n", "2011-09-26 14:30:14.950485851\n", "1630577758569489956\n"};
}

constexpr Target kTargets[] = {{"pcd", read_pcd, pcd_seeds},
                               {"ply", read_ply, ply_seeds},
                               {"kitti", read_kitti, kitti_seeds},
                               {"vlp16", read_vlp16, vlp16_seeds},
                               {"capture", read_capture, capture_seeds},
                               {"text", read_text, text_seeds}};

}  // namespace

std::span<const Target> targets() { return kTargets; }

}  // namespace surefoot::fuzz
