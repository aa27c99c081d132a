// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/map_localizer.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "mapping/moved_things.hpp"
#include "mapping/place_search.hpp"

namespace surefoot::mapping {

namespace {

constexpr std::size_t kPieces = 2;  // finished ones that are kept besides the one being walked
constexpr double kNearest = 8.0;    // a known pose is checked against a place so near [m]
constexpr double kLeastStep = 0.2;  // smaller steps are no way [m]
constexpr double kEnoughWay = 2.0;  // of the piece that is being walked, to be looked at alone [m]
constexpr std::size_t kKept = 12;   // places of the map, some 8 MB each
constexpr std::size_t kAskedAgain = 3;  // places in the next search
constexpr double kWorthAsking = 0.4;    // that fitted so well

}  // namespace

MapLocalizer::MapLocalizer(SavedMap map, const LocalizerOptions& options)
    : map_(std::move(map)),
      held_(held_together(graph_of(map_))),
      options_(options),
      builder_(options.pieces),
      agreement_(options.agreement) {
  for (const PlaceDescriptor& place : map_.places) index_.add(place);
}

void MapLocalizer::add(const PlacedScan& scan, const ScanPoints& points) {
  if (scan.restarted) {
    T_map_world_.reset();
    last_.reset();
    forget_places();
    agreement_.begin_anew();
    forget();
    message_ = "the odometry began anew";
  }
  const Eigen::Vector3d& here = scan.T_world_lidar.translation;
  if (!last_) last_ = here;
  if (const double step = (here - *last_).norm(); step > kLeastStep) {
    way_ += step;
    last_ = here;
  }
  ++scans_;
  const bool looked = std::exchange(looking_, !T_map_world_ || to_check() < options_.look_back);
  if (!looking_) return;
  if (!looked) forget();
  collect(scan, points);
  if (T_map_world_ && to_check() <= 0.0) check();
  if (!T_map_world_ && scans_ % options_.every == 0) search();
}

/// Of way, until the place that is known is looked at again [m].
double MapLocalizer::to_check() const {
  const bool confirmed = succeeded_at_ >= checked_at_;
  return checked_at_ + (confirmed ? options_.check_every : options_.check_again) - way_;
}

void MapLocalizer::forget() {
  PieceOptions pieces = options_.pieces;
  if (T_map_world_) pieces.always = 1;  // from where it should be, little has to be seen
  builder_ = PieceBuilder(pieces);
  recent_.clear();
}

/// A scan that the odometry is not sure of may lie anywhere against those before it, and so may
/// what follows: mostly it is the second one of a run.
void MapLocalizer::collect(const PlacedScan& scan, const ScanPoints& points) {
  if (!is_sure(scan.covariance)) return forget();
  auto done = builder_.add(scan, points);
  if (!done) return;
  recent_.push_back(std::move(*done));
  if (recent_.size() > kPieces) recent_.erase(recent_.begin());
}

std::optional<MapLocalizer::Surroundings> MapLocalizer::surroundings() const {
  std::vector<Piece> pieces = recent_;
  if (auto piece = builder_.unfinished()) pieces.push_back(std::move(*piece));
  if (pieces.empty()) return std::nullopt;
  return Surroundings{VerifiableSubmap(make_submap(pieces, pieces.size() - 1, kPieces)),
                      pieces.back().T_world_piece};
}

bool MapLocalizer::agree_here(const Pose& one, const Pose& other) const {
  return agree(one, other, last_.value_or(Eigen::Vector3d::Zero()), options_.choice);
}

/// A place of the map. Those that were asked for last are kept: they are asked for again.
std::shared_ptr<const VerifiableSubmap> MapLocalizer::submap_of(std::size_t place) {
  const auto known = std::find_if(places_.begin(), places_.end(),
                                  [&](const auto& entry) { return entry.first == place; });
  if (known != places_.end()) {
    std::rotate(known, known + 1, places_.end());
    return places_.back().second;
  }
  if (places_.size() == kKept) places_.erase(places_.begin());
  places_.emplace_back(place, std::make_shared<VerifiableSubmap>(make_submap(map_.pieces, place)));
  return places_.back().second;
}

AskedPlace MapLocalizer::ask_place(std::size_t number, const Surroundings& here,
                                   const Pose& T_place_seen, const LoopLimits& limits) {
  const LoopCheck check =
      check_places(*submap_of(number), here.seen, turned_both_ways(T_place_seen), limits);
  const Pose& T_map_place = map_.pieces[number].T_world_piece;
  return {T_map_place * check.alignment.T_target_source * here.T_world_seen.inverse(), check,
          held_[number]};
}

/// What fitted in the last search is asked once more where it lay: that a search does not name it
/// any more says little.
void MapLocalizer::ask_again(const Surroundings& here, const LoopLimits& limits,
                             std::vector<AskedPlace>& asked) {
  for (const AskedPlace& fitted : fitted_) {
    const bool known = std::any_of(asked.begin(), asked.end(), [&](const AskedPlace& place) {
      return place.frame == fitted.frame && agree_here(place.T_map_world, fitted.T_map_world);
    });
    const Pose T_map_seen = fitted.T_map_world * here.T_world_seen;
    const auto nearest = nearest_place(T_map_seen.translation, fitted.frame);
    if (known || !nearest) continue;
    const Pose T_place_seen = map_.pieces[*nearest].T_world_piece.inverse() * T_map_seen;
    asked.push_back(ask_place(*nearest, here, T_place_seen, limits));
  }
}

void MapLocalizer::remember(std::vector<AskedPlace> asked) {
  std::stable_sort(asked.begin(), asked.end(), [](const AskedPlace& a, const AskedPlace& b) {
    return fit_of(a.check) > fit_of(b.check);
  });
  fitted_.clear();
  for (const AskedPlace& place : asked) {
    if (fitted_.size() == kAskedAgain || fit_of(place.check) < kWorthAsking) return;
    const bool known = std::any_of(fitted_.begin(), fitted_.end(), [&](const AskedPlace& fitted) {
      return fitted.frame == place.frame && agree_here(fitted.T_map_world, place.T_map_world);
    });
    if (!known) fitted_.push_back(place);
  }
}

/// The one pose that passes every question; none if there is none, or if there are two.
MapLocalizer::Answer MapLocalizer::only_place(const Surroundings& here) {
  std::vector<AskedPlace> asked;
  const auto matches =
      distinct_places(index_, map_.pieces, here.seen.submap(), options_.candidates);
  bool roofed = here.seen.submap().covered;
  for (const PlaceIndex::Match& match : matches) {
    roofed = roofed || submap_of(match.place)->submap().covered;
  }
  const LoopLimits& limits = roofed ? options_.roofed_limits : options_.limits;
  for (const PlaceIndex::Match& match : matches) {
    const Pose rough = rough_pose(match, submap_of(match.place)->submap(), here.seen.submap());
    asked.push_back(ask_place(match.place, here, rough, limits));
  }
  ask_again(here, limits, asked);
  const PlaceChoice choice = choose_place(asked, last_.value_or(Eigen::Vector3d::Zero()),
                                          roofed ? options_.roofed_choice : options_.choice);
  Answer answer{.place = std::nullopt, .several = choice.several};
  if (choice.chosen) {
    const AskedPlace& chosen = asked[*choice.chosen];
    answer.place = OnlyPlace{chosen.T_map_world, choice.fit, chosen.frame};
  }
  if (choice.alike) agreement_.add_alike(way_);
  for (const AskedPlace& place : asked) {
    agreement_.add_missing(place.T_map_world, place.check.missing, way_);
  }
  remember(std::move(asked));
  return answer;
}

void MapLocalizer::search() {
  const auto here = surroundings();
  if (!here) {
    message_ = "not found yet: the odometry is not sure of its way";
    return forget_places();
  }
  const Answer answer = only_place(*here);
  if (!answer.place) {
    message_ =
        answer.several ? "not found yet: several places fit" : "not found yet: no place fits";
    return answer.several ? agreement_.forget() : agreement_.add_silence();
  }
  const auto& [T_map_world, fit, frame] = *answer.place;
  const Eigen::Vector3d robot = last_.value_or(Eigen::Vector3d::Zero());
  if (!agreement_.add(T_map_world, fit, way_, robot, options_.choice)) {
    message_ = "not found yet: a place fits, and is asked again";
    return;
  }
  T_map_world_ = T_map_world;
  frame_ = frame;
  forget_places();
  checked_at_ = succeeded_at_ = way_;
  message_ = "found";
}

void MapLocalizer::forget_places() {
  agreement_.forget();
  fitted_.clear();
  elsewhere_.reset();
}

/// The nearest place of a frame within reach; none: the map does not show it. Those of others are
/// anywhere.
std::optional<std::size_t> MapLocalizer::nearest_place(const Eigen::Vector3d& at,
                                                       std::size_t frame) const {
  std::optional<std::size_t> nearest;
  double distance = kNearest;
  for (std::size_t i = 0; i < map_.pieces.size(); ++i) {
    if (held_[i] != frame) continue;
    const double apart = (map_.pieces[i].T_world_piece.translation - at).norm();
    if (apart >= distance) continue;
    distance = apart;
    nearest = i;
  }
  return nearest;
}

/// Where the map says that the odometry's world lies, from where it was taken to lie; none if it
/// does not show what is seen. From one start alone: the odometry has not gone far since.
std::optional<Pose> MapLocalizer::confirmed() {
  const auto walked = builder_.unfinished();
  if (!walked && recent_.empty()) return std::nullopt;
  const bool enough = walked && (recent_.empty() || walked->length > kEnoughWay);
  const Piece& piece = enough ? *walked : recent_.back();
  const auto nearest = nearest_place(*T_map_world_ * piece.T_world_piece.translation, frame_);
  if (!nearest) return std::nullopt;
  // Two pieces alone: while the place is known, little time may be spent on it.
  const VerifiableSubmap place(make_submap(map_.pieces[*nearest]));
  const VerifiableSubmap seen(make_submap(piece));
  const Pose& T_map_place = map_.pieces[*nearest].T_world_piece;
  const Pose expected = T_map_place.inverse() * *T_map_world_ * piece.T_world_piece;
  const SubmapAlignment found =
      align_submaps(place.registration(), seen.registration(), expected, 1);
  const Pose T_map_world = T_map_place * found.T_target_source * piece.T_world_piece.inverse();
  if (found.matched < options_.confirming ||
      missing_between(place, seen, found.T_target_source) > options_.missing_at_most) {
    return std::nullopt;
  }
  // The odometry may have drifted farther than that; then the next look says so, too.
  const bool twice = elsewhere_ && agree_here(*elsewhere_, T_map_world);
  if (!twice && !agree_here(*T_map_world_, T_map_world)) {
    elsewhere_ = T_map_world;
    return std::nullopt;
  }
  elsewhere_.reset();
  // What the registration does not hold (the way along a corridor) stays as it was.
  return found.held == 6 ? T_map_world : *T_map_world_;
}

/// Looks at the map where the robot should be; the odometry's drift is taken back.
void MapLocalizer::check() {
  checked_at_ = way_;
  const std::optional<Pose> T_map_world = confirmed();
  if (T_map_world) {
    T_map_world_ = T_map_world;
    succeeded_at_ = way_;
  }
  message_ = T_map_world ? "found" : "found; the last look at the map did not confirm it";
  if (way_ - succeeded_at_ > options_.lost_after) {
    T_map_world_.reset();
    forget();
    message_ = "lost: the map has not been confirmed for some metres";
  }
}

}  // namespace surefoot::mapping
