// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/place_index.hpp"

#include <algorithm>

namespace surefoot::mapping {

namespace {

constexpr std::size_t kByKey = 40;  // places whose columns are compared

struct ByKey {
  double distance;
  std::size_t place;
  std::size_t offset;
};

Pose rough_pose(const DescriptorDistance& found, const Eigen::Vector2d& centre) {
  Pose pose;
  pose.rotation = Eigen::AngleAxisd(found.yaw(), Eigen::Vector3d::UnitZ());
  pose.translation = -(pose.rotation * Eigen::Vector3d(centre.x(), centre.y(), 0.0));
  return pose;
}

}  // namespace

std::vector<PlaceIndex::Match> PlaceIndex::search(const std::vector<OffsetDescriptor>& query,
                                                  const std::function<bool(std::size_t)>& allowed,
                                                  std::size_t most) const {
  std::vector<ByKey> candidates;
  for (std::size_t place = 0; place < places_.size(); ++place) {
    if (!allowed(place)) continue;
    for (std::size_t offset = 0; offset < query.size(); ++offset) {
      candidates.push_back({key_distance(places_[place], query[offset].descriptor), place, offset});
    }
  }
  // A place has as many entries as the query has offsets.
  const std::size_t kept = std::min(candidates.size(), kByKey * 3);
  std::partial_sort(candidates.begin(), candidates.begin() + static_cast<std::ptrdiff_t>(kept),
                    candidates.end(), [](const ByKey& a, const ByKey& b) {
                      if (a.distance != b.distance) return a.distance < b.distance;
                      return a.place != b.place ? a.place < b.place : a.offset < b.offset;
                    });
  candidates.resize(kept);
  std::vector<TurnedPlace> turned;
  for (const OffsetDescriptor& seen : query) turned.emplace_back(seen.descriptor);
  std::vector<Match> matches;
  for (const ByKey& candidate : candidates) {
    const OffsetDescriptor& seen = query[candidate.offset];
    const DescriptorDistance found =
        turned[candidate.offset].distance_from(places_[candidate.place]);
    const auto known = std::find_if(matches.begin(), matches.end(), [&](const Match& match) {
      return match.place == candidate.place;
    });
    const Match match{candidate.place, found.distance, rough_pose(found, seen.centre)};
    if (known == matches.end()) {
      matches.push_back(match);
    } else if (match.distance < known->distance) {
      *known = match;
    }
  }
  std::stable_sort(matches.begin(), matches.end(),
                   [](const Match& a, const Match& b) { return a.distance < b.distance; });
  if (matches.size() > most) matches.resize(most);
  return matches;
}

}  // namespace surefoot::mapping
