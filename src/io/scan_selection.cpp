// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/scan_selection.hpp"

#include <algorithm>

namespace surefoot::io {
namespace {

class SelectedRecording final : public Recording {
 public:
  SelectedRecording(std::unique_ptr<Recording> recording, std::vector<std::int64_t> stamps_ns)
      : recording_(std::move(recording)), stamps_ns_(std::move(stamps_ns)) {}

  std::optional<ScanItem> next() override {
    while (std::optional<ScanItem> item = recording_->next()) {
      if (item->scan &&
          std::binary_search(stamps_ns_.begin(), stamps_ns_.end(), item->scan->stamp_ns)) {
        ++found_;
        return item;
      }
    }
    ended_ = true;
    return std::nullopt;
  }
  std::optional<std::size_t> size() const override { return stamps_ns_.size(); }
  void skip(std::size_t scans) override {
    while (scans > 0 && next()) --scans;
  }
  double progress() const override { return recording_->progress(); }
  const std::vector<std::string>& notes() const override {
    notes_ = recording_->notes();
    if (ended_ && found_ < stamps_ns_.size()) {
      notes_.push_back(std::to_string(stamps_ns_.size() - found_) + " of the " +
                       std::to_string(stamps_ns_.size()) + " scans asked for are not there");
    }
    return notes_;
  }
  std::string description() const override { return recording_->description(); }
  CaptureCounts capture_counts() const override { return recording_->capture_counts(); }

 private:
  std::unique_ptr<Recording> recording_;
  std::vector<std::int64_t> stamps_ns_;
  std::size_t found_ = 0;
  bool ended_ = false;
  mutable std::vector<std::string> notes_;
};

}  // namespace

std::unique_ptr<Recording> select_scans(std::unique_ptr<Recording> recording,
                                        std::vector<std::int64_t> stamps_ns) {
  std::sort(stamps_ns.begin(), stamps_ns.end());
  return std::make_unique<SelectedRecording>(std::move(recording), std::move(stamps_ns));
}

}  // namespace surefoot::io
