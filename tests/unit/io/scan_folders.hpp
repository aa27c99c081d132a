// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Folders of scans to be read, and what reading them gives.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "io/recording.hpp"
#include "unit/io/support.hpp"

namespace surefoot::io::test {

// A PCD of points (i + 1, 0, 0) with times of type T, in the order given.
template <typename T>
[[nodiscard]] std::string timed_pcd(const std::vector<T>& times, const char* name = "time") {
  const std::string n = std::to_string(times.size());
  std::string file = std::string("VERSION 0.7\nFIELDS x y z ") + name + "\nSIZE 4 4 4 " +
                     std::to_string(sizeof(T)) + "\nTYPE F F F " +
                     (std::is_floating_point_v<T> ? "F" : "U") + "\nWIDTH " + n + "\nDATA binary\n";
  for (std::size_t i = 0; i < times.size(); ++i) {
    file += little(float(i + 1)) + little(0.0F) + little(0.0F) + little(times[i]);
  }
  return file;
}

[[nodiscard]] inline std::string kitti_scan(std::size_t points) {
  std::string file;
  for (std::size_t i = 0; i < points; ++i) {
    file += little(float(i + 1)) + little(1.0F) + little(2.0F) + little(0.5F);
  }
  return file;
}

[[nodiscard]] inline std::vector<ScanItem> read_all(const std::filesystem::path& path,
                                                    const OpenOptions& options = {}) {
  std::vector<ScanItem> items;
  const auto recording = open_recording(path, options);
  while (auto item = recording->next()) {
    items.push_back(std::move(*item));
  }
  EXPECT_EQ(recording->progress(), 1.0);
  return items;
}

[[nodiscard]] inline std::string error_of(const std::filesystem::path& path,
                                          const OpenOptions& options = {}) {
  return message_of<ReadError>([&] { (void)open_recording(path, options); });
}

}  // namespace surefoot::io::test
