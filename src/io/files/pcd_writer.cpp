// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/files/pcd_writer.hpp"

#include <lzf.h>

#include <algorithm>
#include <limits>

#include "io/file_writer.hpp"

namespace surefoot::io {
namespace {

bool has_negative_time(const Scan& scan) {
  return std::any_of(scan.times_ns.begin(), scan.times_ns.end(), [](auto t) { return t < 0; });
}

std::string header_of(const Scan& scan, const char* data) {
  std::string fields = "x y z";
  std::string sizes = "4 4 4";
  std::string types = "F F F";
  std::string counts = "1 1 1";
  const auto add = [&](const char* name, const char* size, const char* type) {
    fields += std::string(" ") + name;
    sizes += std::string(" ") + size;
    types += std::string(" ") + type;
    counts += " 1";
  };
  if (!scan.intensities.empty()) {
    add("intensity", "4", "F");
  }
  if (!scan.times_ns.empty()) {
    add("t", "4", has_negative_time(scan) ? "I" : "U");
  }
  if (!scan.rings.empty()) {
    add("ring", "2", "U");
  }
  const std::string points = std::to_string(scan.points.size());
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS " + fields + "\nSIZE " +
         sizes + "\nTYPE " + types + "\nCOUNT " + counts + "\nWIDTH " + points +
         "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + points + "\nDATA " + data + "\n";
}

void check_lengths(const Scan& scan) {
  const auto fits = [&scan](const auto& values) {
    return values.empty() || values.size() == scan.points.size();
  };
  if (!fits(scan.intensities) || !fits(scan.times_ns) || !fits(scan.rings)) {
    throw std::invalid_argument("a scan's arrays must be empty or as long as its points");
  }
}

void append_ascii(const Scan& scan, std::string& out) {
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    append_text(out, scan.points[i].x());
    out += ' ';
    append_text(out, scan.points[i].y());
    out += ' ';
    append_text(out, scan.points[i].z());
    if (!scan.intensities.empty()) {
      out += ' ';
      append_text(out, scan.intensities[i]);
    }
    if (!scan.times_ns.empty()) {
      out += ' ' + std::to_string(scan.times_ns[i]);
    }
    if (!scan.rings.empty()) {
      out += ' ' + std::to_string(scan.rings[i]);
    }
    out += '\n';
  }
}

void append_binary(const Scan& scan, std::string& out) {
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    out.append(reinterpret_cast<const char*>(scan.points[i].data()), 3 * sizeof(float));
    if (!scan.intensities.empty()) {
      append_bytes(out, scan.intensities[i]);
    }
    if (!scan.times_ns.empty()) {
      append_bytes(out, scan.times_ns[i]);
    }
    if (!scan.rings.empty()) {
      append_bytes(out, scan.rings[i]);
    }
  }
}

template <typename T>
void append_all(std::string& out, const std::vector<T>& values) {
  out.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

void append_compressed(const Scan& scan, std::string& out) {
  std::string plain;
  for (int axis = 0; axis < 3; ++axis) {
    for (const Eigen::Vector3f& point : scan.points) {
      append_bytes(plain, point[axis]);
    }
  }
  append_all(plain, scan.intensities);
  append_all(plain, scan.times_ns);
  append_all(plain, scan.rings);
  if (plain.size() > std::numeric_limits<std::uint32_t>::max() / 2) {
    throw std::invalid_argument("too many points for PCD binary_compressed");
  }
  const auto size = static_cast<std::uint32_t>(plain.size());
  // LZF grows what it cannot compress by less than 4 %.
  std::string packed(plain.size() + plain.size() / 16 + 64, '\0');
  const std::uint32_t packed_size = size == 0
                                        ? 0
                                        : lzf_compress(plain.data(), size, packed.data(),
                                                       static_cast<std::uint32_t>(packed.size()));
  append_bytes(out, packed_size);
  append_bytes(out, size);
  out.append(packed, 0, packed_size);
}

}  // namespace

std::string format_pcd(const Scan& scan, PcdData flavour) {
  check_lengths(scan);
  std::string out;
  out.reserve(1024 + 32 * scan.points.size());
  switch (flavour) {
    case PcdData::ascii:
      out = header_of(scan, "ascii");
      append_ascii(scan, out);
      break;
    case PcdData::binary:
      out = header_of(scan, "binary");
      append_binary(scan, out);
      break;
    case PcdData::binary_compressed:
      out = header_of(scan, "binary_compressed");
      append_compressed(scan, out);
      break;
  }
  return out;
}

void write_pcd(const std::filesystem::path& file, const Scan& scan, PcdData flavour) {
  write_whole_file(file, format_pcd(scan, flavour));
}

}  // namespace surefoot::io
