// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/front_end.hpp"
#include "methods/knots/evidence.hpp"
#include "methods/knots/surfel_map.hpp"

namespace surefoot {

/// The map and the last views. What a scan saw enters them while its pose is already on its way to
/// the caller, and while the next scan is thinned; whoever asks for anything waits for that.
class GrowingMap {
 public:
  explicit GrowingMap(const Session& session);

  /// Begins to add what a trusted scan saw.
  void add(View view);
  void clear();
  /// That nothing was emptied, until something is added.
  void forget_emptied();

  [[nodiscard]] const SurfelMap& surfels() const;
  [[nodiscard]] const LastViews& views() const;
  /// What the last scan's beams emptied.
  [[nodiscard]] const Cubes& emptied() const;

 private:
  const Workers& workers_;
  SurfelMap surfels_;
  LastViews views_;
  Cubes emptied_;
  Background adding_;  // to all of the above; the last member, so that it ends before they do
};

}  // namespace surefoot
