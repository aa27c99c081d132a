// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/map_localizer.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "mapping/place_search.hpp"

namespace surefoot::mapping {

namespace {

constexpr std::size_t kPieces = 2;  // finished ones that are kept besides the one being walked
constexpr double kNearest = 8.0;    // a known pose is checked against a place so near [m]
constexpr double kLeastStep = 0.2;  // smaller steps are no way [m]
constexpr double kEnoughWay = 2.0;  // of the piece that is being walked, to be looked at alone [m]
constexpr std::size_t kKept = 12;   // places of the map, some 8 MB each

}  // namespace

MapLocalizer::MapLocalizer(SavedMap map, const LocalizerOptions& options)
    : map_(std::move(map)), options_(options), builder_(options.pieces) {
  for (const PlaceDescriptor& place : map_.places) index_.add(place);
}

void MapLocalizer::add(const PlacedScan& scan, const ScanPoints& points) {
  if (scan.restarted) {
    T_map_world_.reset();
    agreed_.reset();
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

/// The one pose that passes every question; none if there is none, or if there are two.
std::optional<MapLocalizer::OnlyPlace> MapLocalizer::only_place(const Surroundings& here) {
  std::vector<AskedPlace> asked;
  const Pose T_here_world = here.T_world_seen.inverse();
  const auto matches =
      distinct_places(index_, map_.pieces, here.seen.submap(), options_.candidates);
  bool roofed = here.seen.submap().covered;
  for (const PlaceIndex::Match& match : matches) {
    roofed = roofed || submap_of(match.place)->submap().covered;
  }
  const LoopLimits& limits = roofed ? options_.roofed_limits : options_.limits;
  for (const PlaceIndex::Match& match : matches) {
    const auto place = submap_of(match.place);
    const LoopCheck check = check_match(match, *place, here.seen, limits);
    const Pose& T_map_place = map_.pieces[match.place].T_world_piece;
    asked.push_back({T_map_place * check.alignment.T_target_source * T_here_world, check});
  }
  const PlaceChoice choice = choose_place(asked, last_.value_or(Eigen::Vector3d::Zero()),
                                          roofed ? options_.roofed_choice : options_.choice);
  if (choice.several) {
    message_ = "not found yet: several places fit";
    alike_at_ = way_;
  }
  if (!choice.chosen && !choice.several) message_ = "not found yet: no place fits";
  if (!choice.chosen) return std::nullopt;
  return OnlyPlace{asked[*choice.chosen].T_map_world, choice.fit};
}

/// While the robot stands it sees the same, and what looks alike by chance stays alike: then it has
/// to fit well. And of two that were alike one that is not named any more is no less alike.
bool MapLocalizer::is_enough(const Agreed& agreed) const {
  if (alike_at_ && way_ - *alike_at_ < options_.alike_way) return false;
  return agreed.searches >= options_.agreeing &&
         (way_ - agreed.since >= options_.agreeing_way || agreed.fit >= options_.fit_standing);
}

void MapLocalizer::search() {
  const auto here = surroundings();
  if (!here) message_ = "not found yet: the odometry is not sure of its way";
  const auto found = here ? only_place(*here) : std::nullopt;
  if (!found) return agreed_.reset();
  if (!agreed_ || !agree_here(agreed_->T_map_world, found->T_map_world)) {
    agreed_ = Agreed{.T_map_world = found->T_map_world, .since = way_};
  }
  agreed_->T_map_world = found->T_map_world;
  agreed_->fit = std::min(agreed_->fit, found->fit);
  ++agreed_->searches;
  if (!is_enough(*agreed_)) {
    message_ = "not found yet: a place fits, and is asked again";
    return;
  }
  T_map_world_ = agreed_->T_map_world;
  agreed_.reset();
  checked_at_ = succeeded_at_ = way_;
  message_ = "found";
}

/// The nearest place within reach; none: the map does not show it.
std::optional<std::size_t> MapLocalizer::nearest_place(const Eigen::Vector3d& at) const {
  std::optional<std::size_t> nearest;
  double distance = kNearest;
  for (std::size_t i = 0; i < map_.pieces.size(); ++i) {
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
  const auto nearest = nearest_place(*T_map_world_ * piece.T_world_piece.translation);
  if (!nearest) return std::nullopt;
  // Two pieces alone: while the place is known, little time may be spent on it.
  const VerifiableSubmap place(make_submap(map_.pieces[*nearest]));
  const VerifiableSubmap seen(make_submap(piece));
  const Pose& T_map_place = map_.pieces[*nearest].T_world_piece;
  const Pose expected = T_map_place.inverse() * *T_map_world_ * piece.T_world_piece;
  const SubmapAlignment found =
      align_submaps(place.registration(), seen.registration(), expected, 1);
  const Pose T_map_world = T_map_place * found.T_target_source * piece.T_world_piece.inverse();
  if (found.matched < options_.confirming || !agree_here(*T_map_world_, T_map_world)) {
    return std::nullopt;
  }
  if (missing_between(place, seen, found.T_target_source) > options_.missing_at_most) {
    return std::nullopt;
  }
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
