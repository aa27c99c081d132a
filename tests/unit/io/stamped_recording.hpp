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

namespace surefoot::io::test {

inline constexpr std::int64_t kSecond = 1'000'000'000;
inline constexpr std::int64_t kFirstScan = 1'700'000'000 * kSecond + 123;

/// Scans out of memory, each of one point that tells its number.
class Stamped : public Recording {
 public:
  explicit Stamped(std::vector<std::int64_t> stamps) : stamps_(std::move(stamps)) {}
  std::optional<ScanItem> next() override {
    if (next_ == stamps_.size()) return std::nullopt;
    ScanItem item;
    item.name = "scan " + std::to_string(next_);
    item.scan.emplace();
    item.scan->points = {{1.0F, 2.0F, static_cast<float>(next_)}};
    item.scan->stamp_ns = stamps_[next_++];
    return item;
  }
  std::optional<std::size_t> size() const override { return stamps_.size(); }
  void skip(std::size_t scans) override { next_ = std::min(next_ + scans, stamps_.size()); }
  double progress() const override { return 0.0; }
  const std::vector<std::string>& notes() const override { return notes_; }
  std::string description() const override { return "memory"; }

 private:
  std::vector<std::int64_t> stamps_;
  std::size_t next_ = 0;
  std::vector<std::string> notes_;
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
