// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/growing_map.hpp"

#include <memory>
#include <utility>

namespace surefoot {

GrowingMap::GrowingMap(const Session& session)
    : workers_(session.workers),
      surfels_(session.config.knots, session.config.map.radius),
      adding_(session.workers) {}

void GrowingMap::add(View view) {
  // Shared, since a std::function can be copied.
  const auto seen = std::make_shared<View>(std::move(view));
  adding_.begin([this, seen] {
    surfels_.remove_far(seen->sensor);
    emptied_ = surfels_.insert(*seen, workers_);
    views_.add(std::move(*seen));
  });
}

void GrowingMap::clear() {
  adding_.wait();
  surfels_.clear();
  views_.clear();
}

void GrowingMap::forget_emptied() {
  adding_.wait();
  emptied_.centres.clear();
}

const SurfelMap& GrowingMap::surfels() const {
  adding_.wait();
  return surfels_;
}

const LastViews& GrowingMap::views() const {
  adding_.wait();
  return views_;
}

const Cubes& GrowingMap::emptied() const {
  adding_.wait();
  return emptied_;
}

}  // namespace surefoot
