// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What targets share: points, once a parser has understood them, go the whole way to a scan.
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/all_fields.hpp"

namespace surefoot::fuzz {

using Bytes = std::span<const std::byte>;
using Seeds = std::vector<std::string>;

/// A file in memory, for readers that take a name alone; its bytes are those it was given last.
class MemoryFile {
 public:
  std::string holding(Bytes bytes) const {
    if (ftruncate(file_, 0) != 0 || pwrite(file_, bytes.data(), bytes.size(), 0) < 0) std::abort();
    return "/proc/self/fd/" + std::to_string(file_);
  }

 private:
  int file_ = memfd_create("fuzzed", 0);
};

/// As a recording does; throws ReadError.
inline void go_on_to_a_scan(const io::PointTable& table, std::optional<std::int64_t> stamp_ns,
                            io::StampAt stamp_at) {
  const io::ScanColumns columns = io::find_scan_columns(table, {});
  std::optional<io::PointTimeRule> rule;
  if (columns.time != nullptr) {
    const io::TimeExtents extents = io::time_extents(table, columns);
    rule = io::decide_point_time(extents, columns.time->type, stamp_ns, {});
  }
  const io::BuiltScan built = io::build_scan(table, columns, rule, stamp_ns, stamp_at);
  io::ScanItem item;
  io::take_all_fields(table, columns, built, item);
}

inline Scan small_scan() {
  Scan scan;
  for (int i = 0; i < 4; ++i) {
    scan.points.emplace_back(1.0F + static_cast<float>(i), -2.0F, 0.5F);
    scan.intensities.push_back(7.0F);
    scan.times_ns.push_back(i * 25'000'000);
    scan.rings.push_back(static_cast<std::uint16_t>(i));
  }
  return scan;
}

}  // namespace surefoot::fuzz
