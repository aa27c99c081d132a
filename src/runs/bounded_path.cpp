// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/bounded_path.hpp"

namespace surefoot::runs {

void BoundedPath::add(const StampedPose& pose, bool untrusted, int segment) {
  const bool only_newest = added_ > 0 && (added_ - 1) % stride_ != 0;
  if (only_newest) drop_newest();
  poses_.push_back(pose);
  untrusted_.push_back(untrusted);
  segments_.push_back(segment);
  ++added_;
  if (poses_.size() > most_) thin();
}

void BoundedPath::drop_newest() {
  const bool untrusted = untrusted_.back();
  poses_.pop_back();
  untrusted_.pop_back();
  segments_.pop_back();
  if (untrusted) untrusted_.back() = true;
}

void BoundedPath::thin() {
  stride_ *= 2;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    if (i % 2 == 0 || i + 1 == poses_.size()) {
      poses_[kept] = poses_[i];
      untrusted_[kept] = untrusted_[i];
      segments_[kept] = segments_[i];
      ++kept;
    } else if (untrusted_[i]) {
      untrusted_[kept - 1] = true;
    }
  }
  poses_.resize(kept);
  untrusted_.resize(kept);
  segments_.resize(kept);
}

}  // namespace surefoot::runs
