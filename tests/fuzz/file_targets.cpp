// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "fuzz/targets.hpp"

#include <cstdio>
#include <cstdlib>
#include <memory>

#include "fuzz/whole_way.hpp"
#include "io/ascii_values.hpp"
#include "io/bags/bag_metadata.hpp"
#include "io/files/pcd_writer.hpp"
#include "io/files/ply_writer.hpp"
#include "io/files/scan_files.hpp"
#include "io/stamps.hpp"
#include "io/trajectory_files.hpp"
#include "io/truth_files.hpp"
#include "unit/io/support.hpp"

namespace surefoot::fuzz {
namespace {

// Parses a file and goes on.
void read_scan(io::ScanFileKind kind, Bytes bytes) {
  try {
    go_on_to_a_scan(io::parse_scan_file(kind, bytes), std::nullopt, io::StampAt::start);
  } catch (const io::ReadError&) {
  }
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
  attempt([](std::string_view stamps) { return io::parse_stamps(stamps); });
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

constexpr Target kFileTargets[] = {{"pcd", read_pcd, pcd_seeds},
                                   {"ply", read_ply, ply_seeds},
                                   {"kitti", read_kitti, kitti_seeds},
                                   {"las", read_las, las_seeds},
                                   {"text", read_text, text_seeds}};

}  // namespace

std::span<const Target> file_targets() { return kFileTargets; }

}  // namespace surefoot::fuzz
