// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Recordings out of memory whose stamps are to be mended, and what they are mended to.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/stamp_repair.hpp"
#include "support/memory_recording.hpp"

namespace surefoot::io::test {

inline constexpr std::int64_t kSecond = 1'000'000'000;
inline constexpr std::int64_t kFirstScan = 1'700'000'000 * kSecond + 123;

/// Scans out of memory, each of one point that tells its number.
class Stamped : public surefoot::test::MemoryRecording {
 public:
  explicit Stamped(const std::vector<std::int64_t>& stamps) : MemoryRecording(scans_at(stamps)) {}

 private:
  static std::vector<Scan> scans_at(const std::vector<std::int64_t>& stamps) {
    std::vector<Scan> scans(stamps.size());
    for (std::size_t i = 0; i < stamps.size(); ++i) {
      scans[i].points = {{1.0F, 2.0F, static_cast<float>(i)}};
      scans[i].stamp_ns = stamps[i];
    }
    return scans;
  }
};

/// At 10 Hz.
inline std::vector<std::int64_t> regular(std::size_t count) {
  std::vector<std::int64_t> stamps;
  for (std::size_t i = 0; i < count; ++i) {
    stamps.push_back(kFirstScan + static_cast<std::int64_t>(i) * kSecond / 10);
  }
  return stamps;
}

struct Repaired {
  std::vector<std::int64_t> stamps;
  std::vector<std::string> notes;
};

inline Repaired repaired(std::unique_ptr<Recording> given, const OpenOptions& options) {
  const auto recording = repair_stamps(std::move(given), options);
  Repaired result;
  while (const auto item = recording->next()) result.stamps.push_back(item->scan->stamp_ns);
  result.notes = recording->notes();
  return result;
}

inline Repaired repaired(std::vector<std::int64_t> stamps) {
  return repaired(std::make_unique<Stamped>(std::move(stamps)), {});
}

/// Scans whose points have times, from the stamp on.
class Swept : public Stamped {
 public:
  Swept(std::vector<std::int64_t> stamps, std::int32_t lasts_ns)
      : Stamped(std::move(stamps)), lasts_ns_(lasts_ns) {}
  std::optional<ScanItem> next() override {
    std::optional<ScanItem> item = Stamped::next();
    if (!item) return item;
    item->scan->points.push_back(item->scan->points.front());
    item->scan->times_ns = {0, lasts_ns_};
    return item;
  }

 private:
  std::int32_t lasts_ns_;
};

inline Repaired repaired_sweeps(std::vector<std::int64_t> stamps,
                                std::int32_t lasts_ns = 99'900'000,
                                const OpenOptions& options = {}) {
  return repaired(std::make_unique<Swept>(std::move(stamps), lasts_ns), options);
}

}  // namespace surefoot::io::test
