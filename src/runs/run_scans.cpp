// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/run_scans.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "text/printable.hpp"

namespace surefoot::runs {

std::optional<io::ScanItem> RunScans::first() {
  recording_->skip(options_.start);
  auto first = recording_->next();
  const bool is_chosen = !options_.only_stamps.empty();  // by a run that left out its own part
  if (!first || first->remark.empty() || is_chosen) return first;
  auto second = recording_->next();
  if (!second) return first;
  left_out_ = fmt::format("left out: {}: {}", text::printable(first->name), first->remark);
  return second;
}

std::optional<io::ScanItem> RunScans::next() {
  if (ahead_.empty()) return read();
  std::optional<io::ScanItem> item = std::move(ahead_.front());
  ahead_.pop_front();
  return item;
}

const io::ScanItem* RunScans::ahead(std::size_t i) {
  while (ahead_.size() <= i) {
    std::optional<io::ScanItem> item = read();
    if (!item) return nullptr;
    ahead_.push_back(std::move(*item));
  }
  return &ahead_[i];
}

double RunScans::progress(std::size_t done) const {
  if (const auto size = recording_->size()) {
    const std::size_t left = *size > options_.start ? *size - options_.start : 1;
    const std::size_t total =
        std::min((left + options_.stride - 1) / options_.stride, options_.count);
    return static_cast<double>(done) / static_cast<double>(std::max<std::size_t>(total, 1));
  }
  return recording_->progress();
}

void RunScans::begin_again(std::unique_ptr<io::Recording> recording) {
  again_ = std::move(recording);
  recording_ = again_.get();
  ahead_.clear();
}

std::optional<io::ScanItem> RunScans::read() {
  recording_->skip(options_.stride - 1);
  return recording_->next();
}

}  // namespace surefoot::runs
