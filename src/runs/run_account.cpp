// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/run_account.hpp"

#include <fmt/format.h>

#include "text/printable.hpp"

namespace surefoot::runs {

namespace {
constexpr std::size_t kMostNoted = 10;       // scans that could not be read
constexpr std::size_t kMostTimes = 100'000;  // the last ones are kept
}  // namespace

void RunAccount::say_notes_of(const io::Recording& recording) {
  const std::vector<std::string>& all = recording.notes();
  for (; said_.size() < all.size(); said_.push_back(all[said_.size()])) {
    listener_.say("note: " + text::printable(all[said_.size()]));
  }
}

void RunAccount::leave_out(const io::ScanItem& item) {
  const std::string text = "left out: " + text::printable(item.error);
  if (++outcome_.unreadable <= kMostNoted) note(text);
  listener_.complain ? listener_.complain(text) : listener_.say(text);
}

void RunAccount::add(const io::ScanItem& item, const Estimate& estimate, double milliseconds) {
  tell(item, estimate);
  ++outcome_.statuses[estimate.status];
  std::vector<double>& times = outcome_.milliseconds;
  if (times.size() < kMostTimes) times.emplace_back();
  times[outcome_.used++ % kMostTimes] = milliseconds;
}

/// Each trouble once, when it begins.
void RunAccount::tell(const io::ScanItem& item, const Estimate& estimate) {
  const bool serious = !estimate.trusted() || estimate.status == Status::first_scan;
  if (serious && estimate.status != last_status_) {
    listener_.say(fmt::format("{}: {}: {}", text::printable(item.name), to_string(estimate.status),
                              estimate.message));
  }
  last_status_ = estimate.status;
  if (!estimate.trusted()) return;
  if (estimate.segment < last_segment_) {
    listener_.say(fmt::format("{}: came home: it goes on in segment {}", text::printable(item.name),
                              estimate.segment));
  }
  last_segment_ = estimate.segment;
}

std::vector<std::string> RunAccount::notes() const {
  std::vector<std::string> all = said_;
  all.insert(all.end(), own_.begin(), own_.end());
  return all;
}

std::size_t RunAccount::untrusted() const {
  std::size_t count = 0;
  for (const Status status :
       {Status::too_few_matches, Status::diverged, Status::lost, Status::rejected}) {
    const auto found = outcome_.statuses.find(status);
    if (found != outcome_.statuses.end()) count += found->second;
  }
  return count;
}

}  // namespace surefoot::runs
