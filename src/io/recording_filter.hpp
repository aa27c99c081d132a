// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A recording that gives out another one's scans, changed or chosen, and has notes of its own.
#pragma once

#include <deque>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "io/recording.hpp"

namespace surefoot::io {

/// What does not differ between filters; next() is theirs.
class RecordingFilter : public Recording {
 public:
  [[nodiscard]] std::optional<std::size_t> size() const override { return recording_->size(); }
  void skip(std::size_t scans) override {
    for (; scans > 0 && !waiting_.empty(); --scans) waiting_.pop_front();
    if (scans > 0) recording_->skip(scans);
  }
  [[nodiscard]] double progress() const override { return recording_->progress(); }
  [[nodiscard]] const std::vector<std::string>& notes() const override { return notes_; }
  [[nodiscard]] std::string description() const override { return recording_->description(); }
  [[nodiscard]] CaptureCounts capture_counts() const override {
    return recording_->capture_counts();
  }
  [[nodiscard]] std::vector<std::string> losses() const override { return recording_->losses(); }
  [[nodiscard]] std::string topic() const override { return recording_->topic(); }

 protected:
  explicit RecordingFilter(std::unique_ptr<Recording> recording)
      : recording_(std::move(recording)) {}

  [[nodiscard]] Recording& recording() { return *recording_; }
  /// Scans that were read ahead; skip() passes over them first.
  [[nodiscard]] std::deque<ScanItem>& waiting() { return waiting_; }
  [[nodiscard]] const std::deque<ScanItem>& waiting() const { return waiting_; }

  void note(std::string text) {
    own_notes_.push_back(std::move(text));
    merge_notes();
  }
  /// The recording's own notes grow, too; what was given out once stays where it is.
  void merge_notes() {
    const std::vector<std::string>& inner = recording_->notes();
    for (; taken_ < inner.size(); ++taken_) notes_.push_back(inner[taken_]);
    for (; taken_own_ < own_notes_.size(); ++taken_own_) notes_.push_back(own_notes_[taken_own_]);
  }

 private:
  std::unique_ptr<Recording> recording_;
  std::deque<ScanItem> waiting_;
  std::vector<std::string> notes_, own_notes_;
  std::size_t taken_ = 0, taken_own_ = 0;
};

}  // namespace surefoot::io
