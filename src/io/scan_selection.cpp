// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/scan_selection.hpp"

#include <algorithm>

#include "io/recording_filter.hpp"

namespace surefoot::io {
namespace {

class SelectedRecording final : public RecordingFilter {
 public:
  SelectedRecording(std::unique_ptr<Recording> recording, std::vector<std::int64_t> stamps_ns)
      : RecordingFilter(std::move(recording)), stamps_ns_(std::move(stamps_ns)) {
    merge_notes();
  }

  std::optional<ScanItem> next() override {
    while (std::optional<ScanItem> item = recording().next()) {
      merge_notes();
      if (item->scan &&
          std::binary_search(stamps_ns_.begin(), stamps_ns_.end(), item->scan->stamp_ns)) {
        ++found_;
        return item;
      }
    }
    merge_notes();
    if (!ended_ && found_ < stamps_ns_.size()) {
      note(std::to_string(stamps_ns_.size() - found_) + " of the " +
           std::to_string(stamps_ns_.size()) + " scans asked for are not there");
    }
    ended_ = true;
    return std::nullopt;
  }
  std::optional<std::size_t> size() const override { return stamps_ns_.size(); }
  void skip(std::size_t scans) override {
    while (scans > 0 && next()) --scans;
  }

 private:
  std::vector<std::int64_t> stamps_ns_;
  std::size_t found_ = 0;
  bool ended_ = false;
};

}  // namespace

std::unique_ptr<Recording> select_scans(std::unique_ptr<Recording> recording,
                                        std::vector<std::int64_t> stamps_ns) {
  std::sort(stamps_ns.begin(), stamps_ns.end());
  return std::make_unique<SelectedRecording>(std::move(recording), std::move(stamps_ns));
}

}  // namespace surefoot::io
