// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// For tests that link io.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "io/recording.hpp"

namespace surefoot::test {

/// Scans out of memory.
class MemoryRecording : public io::Recording {
 public:
  explicit MemoryRecording(std::vector<io::ScanItem> items, std::vector<std::string> notes = {})
      : items_(std::move(items)), notes_(std::move(notes)) {}
  explicit MemoryRecording(std::vector<Scan> scans, std::vector<std::string> notes = {})
      : MemoryRecording(items_of(std::move(scans)), std::move(notes)) {}

  std::optional<io::ScanItem> next() override {
    if (next_ == items_.size()) return std::nullopt;
    return items_[next_++];
  }
  std::optional<std::size_t> size() const override { return items_.size(); }
  void skip(std::size_t scans) override { next_ = std::min(next_ + scans, items_.size()); }
  double progress() const override { return 0.0; }
  const std::vector<std::string>& notes() const override { return notes_; }
  std::string description() const override { return "memory"; }

 private:
  static std::vector<io::ScanItem> items_of(std::vector<Scan> scans) {
    std::vector<io::ScanItem> items(scans.size());
    for (std::size_t i = 0; i < scans.size(); ++i) {
      items[i].name = "scan " + std::to_string(i);
      items[i].scan = std::move(scans[i]);
    }
    return items;
  }

  std::vector<io::ScanItem> items_;
  std::size_t next_ = 0;
  std::vector<std::string> notes_;
};

}  // namespace surefoot::test
