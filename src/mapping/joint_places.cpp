// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/joint_places.hpp"

#include <algorithm>
#include <optional>

#include "mapping/look_alikes.hpp"
#include "mapping/place_search.hpp"

namespace surefoot::mapping {

namespace {

/// Numbers below `count`: every so many-th, then those half-way between, and so on.
std::vector<std::size_t> spread_out(std::size_t count) {
  std::size_t stride = 1;
  while (2 * stride < count) stride *= 2;
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < count; i += stride) order.push_back(i);
  for (; stride > 1; stride /= 2) {
    for (std::size_t i = stride / 2; i < count; i += stride) order.push_back(i);
  }
  return order;
}

class JointPlaces {
 public:
  JointPlaces(const SavedMap& first, const MapPair& pair, const MergeOptions& options)
      : pair_(pair), options_(options), maps_(pair.pieces) {
    for (const PlaceDescriptor& place : first.places) index_.add(place);
  }

  std::vector<Loop> find() {
    const std::size_t count = pair_.pieces.size() - pair_.first;
    std::vector<std::size_t> order = spread_out(count);
    std::size_t asked = 0;
    for (std::size_t until = options_.survey; asked < count && !placement_; until *= 2) {
      for (; asked < std::min(until, count); ++asked) {
        compare_anywhere(pair_.first + order[asked]);
        tell(asked + 1, count);
      }
      if (asked < count) place();
    }
    // Neighbours one after the other: what they are compared with is asked for again.
    std::sort(order.begin() + static_cast<std::ptrdiff_t>(asked), order.end());
    for (; asked < count; ++asked) {
      compare_where_it_lies(pair_.first + order[asked]);
      tell(asked + 1, count);
    }
    std::stable_sort(loops_.begin(), loops_.end(),
                     [](const Loop& a, const Loop& b) { return a.query < b.query; });
    return loops_;
  }

 private:
  void tell(std::size_t done, std::size_t all) const {
    if (options_.on_piece) options_.on_piece(done, all);
  }

  void compare_anywhere(std::size_t query) {
    const auto seen = maps_.submap(query);
    for (const PlaceIndex::Match& match :
         distinct_places(index_, pair_.pieces, seen->submap(), options_.candidates)) {
      const auto place = maps_.submap(match.place);
      Loop loop;
      loop.place = match.place;
      loop.query = query;
      loop.likeness = match.distance;
      loop.check = check_match(match, *place, *seen, options_.limits);
      add(loop, *place, *seen);
    }
  }

  /// As the maps lie by what was found, if that fits and enough of it agrees.
  void place() {
    for (MapPlacement& placement : find_placements(pair_, loops_, options_.placements)) {
      if (placement.taken < options_.enough || !fits(placement, options_)) continue;
      if (placement_ && placement.support() < placement_->support()) continue;
      placement_ = std::move(placement);
    }
  }

  void compare_where_it_lies(std::size_t query) {
    const auto& second = placement_->of_second;
    if (!std::binary_search(second.begin(), second.end(), query)) {
      compare_anywhere(query);
      return;
    }
    // A loop every other piece holds the maps together as well as one a piece.
    const bool held =
        !loops_.empty() && is_taken(loops_.back()) && loops_.back().query + 1 == query;
    const std::optional<std::size_t> beside = nearest_of_first(query);
    if (held || !beside) return;
    const auto place = maps_.submap(*beside);
    const auto seen = maps_.submap(query);
    Loop loop;
    loop.place = *beside;
    loop.query = query;
    const auto& poses = placement_->solved.poses;
    loop.check = check_places(
        *place, *seen, turned_both_ways(poses[*beside].inverse() * poses[query]), options_.limits);
    add(loop, *place, *seen);
  }

  /// The piece of the first map that shows what is seen from a piece of the second.
  [[nodiscard]] std::optional<std::size_t> nearest_of_first(std::size_t query) const {
    constexpr double kNear = 10.0;  // [m]
    std::optional<std::size_t> result;
    double nearest = kNear;
    const auto& poses = placement_->solved.poses;
    for (const std::size_t place : placement_->of_first) {
      const double apart = area_distance(poses[place].translation, poses[query].translation);
      if (apart < nearest) {
        nearest = apart;
        result = place;
      }
    }
    return result;
  }

  void add(Loop& loop, const VerifiableSubmap& place, const VerifiableSubmap& seen) {
    const bool under_roof = place.submap().covered && seen.submap().covered;
    if (is_taken(loop) && under_roof && !options_.roofed) {
      loop.check.verdict = LoopVerdict::other_storey;
    } else if (is_taken(loop) && looks_alike(loop.check, place, seen)) {
      loop.check.verdict = LoopVerdict::ambiguous;
    }
    loops_.push_back(loop);
  }

  /// Whether the two places would fit otherwise as well.
  bool looks_alike(const LoopCheck& check, const VerifiableSubmap& place,
                   const VerifiableSubmap& seen) const {
    if (check.alignment.held < 6) return true;  // along a corridor, say
    return overlap_slid(check, place, seen) > options_.as_good * check.overlap ||
           fits_turned(check, place, seen, options_.limits);
  }

  const MapPair& pair_;
  const MergeOptions& options_;
  TwoMaps maps_;
  PlaceIndex index_;
  std::vector<Loop> loops_;
  std::optional<MapPlacement> placement_;
};

}  // namespace

std::string objection(const MapPlacement& placement, const MergeOptions& options) {
  if (placement.taken < 2) return "no two places agree on how they lie";
  if (placement.spread < options.spread) {
    return "the places that agree are one place: too little to tell it from its likes";
  }
  const MapComparison& comparison = placement.comparison;
  const bool agrees = comparison.near > 0 && comparison.contradicted <= options.contradicted &&
                      comparison.overlap >= options.overlap;
  return agrees ? "" : "some places agree, but what else both maps have seen does not";
}

std::vector<Loop> find_joint_places(const SavedMap& first, const MapPair& pair,
                                    const MergeOptions& options) {
  return JointPlaces(first, pair, options).find();
}

}  // namespace surefoot::mapping
