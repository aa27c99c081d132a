// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Path and map of a live run as its page draws them: bounded, however long it runs, and told to
// every viewer from where it was left.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <unordered_set>
#include <vector>

#include "live_page/page_scan.hpp"

namespace surefoot::live_page {

/// How far a viewer has been told. All that is kept of it: who is slow makes nothing grow.
struct Told {
  std::uint64_t path = 0, map = 0;  ///< which one; another one is told from its beginning
  std::size_t poses = 0, points = 0;
};

class PageHistory {
 public:
  struct Limits {
    std::size_t poses = 20'000;           ///< more: every second one goes
    std::size_t points = 200'000;         ///< more: the cubes with one point each grow
    std::size_t points_at_once = 40'000;  ///< of one message
    double cube = 0.1;                    ///< [m] to begin with
  };
  PageHistory() : PageHistory(Limits{}) {}
  explicit PageHistory(const Limits& limits) : limits_(limits) {}

  /// A new segment has a path and a map of its own.
  void add(PageScan scan);
  void add(const PageCloud& cloud);

  /// What the viewer has yet to be told of path and map, and the last scan; it counts as told then.
  /// web/src/live/live_run.js reads it.
  [[nodiscard]] nlohmann::ordered_json news(Told& told) const;
  /// Whether the viewer has been told all of the map that there is.
  [[nodiscard]] bool all_told(const Told& told) const;

 private:
  void begin(int segment);
  void thin_path();
  void coarsen_map();
  void keep(const Eigen::Vector3f& point);
  [[nodiscard]] nlohmann::ordered_json path_news(Told& told) const;
  [[nodiscard]] nlohmann::ordered_json map_news(Told& told) const;

  Limits limits_;
  std::optional<PageScan> last_;
  std::int64_t first_stamp_ns_ = 0;
  int segment_ = 0;
  double way_ = 0.0;  ///< [m] in this segment, over all its scans
  std::uint64_t path_number_ = 1, map_number_ = 1;
  std::vector<PageScan> path_;
  std::size_t stride_ = 1;  ///< one scan of so many is kept
  std::size_t since_kept_ = 0;
  double cube_ = 0.1;  ///< [m]
  std::vector<Eigen::Vector3f> points_;
  std::unordered_set<std::uint64_t> cubes_;
};

}  // namespace surefoot::live_page
