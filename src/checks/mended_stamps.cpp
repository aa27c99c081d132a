// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "checks/mended_stamps.hpp"

#include <cmath>
#include <memory>
#include <utility>

#include "io/stamp_repair.hpp"

namespace surefoot::checks {
namespace {

/// Scans again, of which the mending looks at stamps and times alone: the first and the last point
/// of each, unlike the last one's.
class StampReplay final : public io::Recording {
 public:
  explicit StampReplay(const std::vector<ScanFacts>& scans) : scans_(scans) {}

  std::optional<io::ScanItem> next() override {
    if (next_ == scans_.size()) return std::nullopt;
    const ScanFacts& facts = scans_[next_];
    io::ScanItem item;
    item.name = std::to_string(next_++);
    item.logged_ns = facts.logged_ns;
    if (!facts.error.empty()) return item;
    Scan scan;
    scan.stamp_ns = facts.stamp_ns;
    if (!facts.sent_again) ++point_;
    scan.points.assign(2, {static_cast<float>(point_ % 1'000'000), 1.0F, 1.0F});
    if (facts.times != io::PointTimes::none) {
      scan.times_ns = {static_cast<std::int32_t>(std::llround(1e9 * facts.first_s)),
                       static_cast<std::int32_t>(std::llround(1e9 * facts.last_s))};
    }
    item.scan = std::move(scan);
    item.clock = facts.clock;
    return item;
  }
  std::optional<std::size_t> size() const override { return scans_.size(); }
  void skip(std::size_t scans) override { next_ += scans; }
  double progress() const override { return 0.0; }
  const std::vector<std::string>& notes() const override { return notes_; }
  std::string description() const override { return {}; }

 private:
  const std::vector<ScanFacts>& scans_;
  std::vector<std::string> notes_;
  std::size_t next_ = 0;
  std::size_t point_ = 0;
};

}  // namespace

void mend_stamps(std::vector<ScanFacts>& scans, const io::OpenOptions& options) {
  if (!options.repair_stamps) return;
  std::vector<std::pair<std::size_t, std::int64_t>> mended;
  const auto recording = io::repair_stamps(std::make_unique<StampReplay>(scans), options);
  while (const std::optional<io::ScanItem> item = recording->next()) {
    if (item->scan) mended.emplace_back(std::stoul(item->name), item->scan->stamp_ns);
  }
  for (const auto& [index, stamp_ns] : mended) {
    if (stamp_ns != scans[index].stamp_ns) scans[index].mended_ns = stamp_ns;
  }
}

}  // namespace surefoot::checks
