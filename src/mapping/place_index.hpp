// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Places by what they look like. A loose search: what it finds is to be verified.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "mapping/place_descriptor.hpp"
#include "surefoot/pose.hpp"

namespace surefoot::mapping {

class PlaceIndex {
 public:
  struct Match {
    std::size_t place = 0;
    double distance = 1.0;
    Pose T_place_query;  ///< roughly, of the axes on their slopes; without the height
  };

  /// Places are numbered in the order in which they come.
  void add(const PlaceDescriptor& descriptor) { places_.push_back(descriptor); }
  [[nodiscard]] const PlaceDescriptor& place(std::size_t number) const { return places_[number]; }
  [[nodiscard]] std::size_t size() const { return places_.size(); }

  /// The `most` places that look most alike, the best first; `allowed` says which may be.
  [[nodiscard]] std::vector<Match> search(const std::vector<OffsetDescriptor>& query,
                                          const std::function<bool(std::size_t)>& allowed,
                                          std::size_t most) const;

 private:
  std::vector<PlaceDescriptor> places_;
};

}  // namespace surefoot::mapping
