// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/repeated_scans.hpp"

#include <cstring>
#include <optional>
#include <utility>
#include <vector>

#include "io/recording_filter.hpp"

namespace surefoot::io {

namespace {

constexpr std::size_t kRemembered = 10'000;
constexpr std::size_t kSample = 4096;  // points that are compared

class WithoutRepeated final : public RecordingFilter {
 public:
  explicit WithoutRepeated(std::unique_ptr<Recording> recording)
      : RecordingFilter(std::move(recording)) {
    merge_notes();
  }

  std::optional<ScanItem> next() override {
    while (true) {
      std::optional<ScanItem> item = recording().next();
      merge_notes();
      if (!item || !item->scan || !seen_.came_before(*item->scan)) return item;
      if (!std::exchange(noted_, true)) {
        note("stamps: scans that were sent again, first " + item->name +
             ", are left out: the same points at the same stamp");
      }
    }
  }

 private:
  SeenScans seen_;
  bool noted_ = false;
};

}  // namespace

std::uint64_t number_of(const std::vector<Eigen::Vector3f>& points, std::size_t every) {
  std::uint64_t hash = 1469598103934665603ULL ^ points.size();
  for (std::size_t i = 0; i < points.size(); i += every) {
    for (const float value : {points[i].x(), points[i].y(), points[i].z()}) {
      std::uint32_t bits = 0;
      std::memcpy(&bits, &value, sizeof(bits));
      hash = (hash ^ bits) * 1099511628211ULL;
    }
  }
  return hash;
}

bool SeenScans::came_before(const Scan& scan) {
  if (scan.points.empty()) return false;
  const std::uint64_t number = number_of(scan.points, scan.points.size() / kSample + 1);
  const auto [seen, fresh] = numbers_.try_emplace(scan.stamp_ns, number);
  if (!fresh) return std::exchange(seen->second, number) == number;
  order_.push_back(scan.stamp_ns);
  if (order_.size() > kRemembered) {
    numbers_.erase(order_.front());
    order_.pop_front();
  }
  return false;
}

std::unique_ptr<Recording> leave_out_repeated(std::unique_ptr<Recording> recording) {
  return std::make_unique<WithoutRepeated>(std::move(recording));
}

}  // namespace surefoot::io
