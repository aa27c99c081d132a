// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/conversion_lane.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <sstream>

#include "surefoot/seconds.hpp"
#include "text/printable.hpp"

namespace surefoot::io {

const ScanItem* ConversionLane::item() {
  if (item_) return &*item_;
  if (ended_ || scans_ >= request_.count) return nullptr;
  recording_->skip(begun_ ? request_.stride - 1 : request_.start);
  item_ = recording_->next();
  if (!begun_) leave_out_part();
  begun_ = true;
  ended_ = !item_;
  return item_ ? &*item_ : nullptr;
}

void ConversionLane::leave_out_part() {
  if (!item_ || item_->remark.empty()) return;
  std::optional<ScanItem> second = recording_->next();
  if (!second) return;
  left_out_ = "left out: " + text::printable(item_->name) + ": " + item_->remark;
  item_ = std::move(second);
}

void ConversionLane::pass() { item_.reset(); }

bool ConversionLane::is_within(std::int64_t first_ns, std::int64_t at_ns) {
  const double at = seconds(at_ns - first_ns);
  if (at < request_.begin) return false;
  if (at > request_.end) {
    // A single wild stamp is not the end.
    constexpr std::size_t kSurelyLate = 20;
    ended_ = ++late_in_a_row_ >= kSurelyLate;
    return false;
  }
  late_in_a_row_ = 0;
  return true;
}

std::string ConversionLane::add() {
  const ScanItem& item = *item_;
  if (std::string why = sink_->refusal(*item.scan, item.further); !why.empty()) {
    return item.name + ": " + why;
  }
  sink_->add(*item.scan, item.further, item.logged_ns);
  count();
  dropped_points_ += item.dropped_points;
  dropped_empty_ += item.dropped_not_finite + item.dropped_zero;
  rounded_by_ = std::max(rounded_by_, item.rounded_by);
  constexpr std::size_t kMostLosses = 20;
  for (const std::string& loss : item.losses) {
    if (field_losses_.size() < kMostLosses) field_losses_.insert(loss);
  }
  return {};
}

void ConversionLane::count() {
  ++scans_;
  points_ += item_->scan->points.size();
}

std::vector<std::string> ConversionLane::losses() const {
  std::vector<std::string> lines;
  if (!sink_) return lines;
  if (!left_out_.empty()) lines.push_back(left_out_);
  if (const std::string fields = sink_->lost(); !fields.empty()) {
    lines.push_back("lost: fields that are not written to it: " + text::printable(fields));
  }
  std::istringstream remarks(sink_->remark());
  for (std::string line; std::getline(remarks, line);) lines.push_back(line);
  for (const std::string& loss : field_losses_) lines.push_back("lost: " + text::printable(loss));
  if (rounded_by_ > 0.0) {
    std::array<char, 32> metres;
    std::snprintf(metres.data(), metres.size(), "%.2g", rounded_by_);
    lines.push_back(std::string("lost: coordinates become floats, which changes them by up to ") +
                    metres.data() + " m");
  }
  if (dropped_points_ > 0) {
    lines.push_back("left out: " + std::to_string(dropped_points_) +
                    " points without a usable time");
  }
  if (dropped_empty_ > 0) {
    lines.push_back("left out: " + std::to_string(dropped_empty_) +
                    " points that are no returns and of no time of the sweep");
  }
  return lines;
}

}  // namespace surefoot::io
