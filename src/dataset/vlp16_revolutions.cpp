// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "dataset/vlp16_revolutions.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace surefoot::dataset {
namespace {

constexpr double kUnit = 0.01 * std::numbers::pi / 180.0;  // [rad]
constexpr double kTurn = vlp16::kAzimuthUnitsPerTurn;
// The head's azimuth is measured; it may go back by less than this without a new turn [0.01 deg].
constexpr double kJitter = 100.0;
// The slowest head (300 rpm) turns in 0.2 s; one that stands must not fill the memory.
constexpr std::int64_t kLongestNs = 500'000'000;

}  // namespace

Vlp16Revolutions::Vlp16Revolutions(const OpenOptions& options)
    : choice_(options.dual_return), cut_(options.cut_azimuth_deg * 100.0) {
  for (std::size_t id = 0; id < lasers_.size(); ++id) {
    const double elevation = vlp16::kElevationDeg[id] * std::numbers::pi / 180.0;
    const double height =
        options.vlp16_vertical_correction ? 1e-3 * vlp16::kVerticalOffsetMm[id] : 0.0;
    lasers_[id] = {std::cos(elevation), std::sin(elevation), height};
  }
}

void Vlp16Revolutions::add(const Vlp16Packet& packet, std::int64_t stamp_ns,
                           std::int64_t since_last_ns) {
  const double turn_ns = vlp16::kSequenceNs * kTurn / usual_step_;
  if (static_cast<double>(since_last_ns) > turn_ns) {
    finish();  // the azimuth alone would not show that whole turns are missing
  }
  for (std::size_t i = 0; i < packet.sequences(); ++i) {
    const Vlp16Sequence sequence = packet.sequence(i, usual_step_);
    usual_step_ = sequence.azimuth_step;
    const double past_cut = sequence.azimuth - cut_;
    const double position = past_cut < 0.0 ? past_cut + kTurn : past_cut;
    const std::int64_t at_ns = stamp_ns + sequence.offset_ns;
    if (starts_revolution(position, at_ns)) {
      finish();
      begin(at_ns);
    }
    last_position_ = position;
    add_sequence(sequence, packet.is_dual(), at_ns);
  }
}

bool Vlp16Revolutions::starts_revolution(double position, std::int64_t stamp_ns) const {
  return !begun_ || position < last_position_ - kJitter ||
         stamp_ns - current_.scan.stamp_ns > kLongestNs;
}

void Vlp16Revolutions::begin(std::int64_t stamp_ns) {
  begun_ = true;
  current_ = {};
  current_.scan.stamp_ns = stamp_ns;
  current_.scan.points.reserve(usual_points_);
  current_.scan.intensities.reserve(usual_points_);
  current_.scan.times_ns.reserve(usual_points_);
  current_.scan.rings.reserve(usual_points_);
}

void Vlp16Revolutions::finish() {
  // A few firings that met nothing fill a recording's last packet; they are no scan.
  if (begun_ && (current_.is_whole() || !current_.scan.points.empty())) {
    usual_points_ = current_.scan.points.size() + current_.scan.points.size() / 8;
    ended_.push_back(std::move(current_));
  }
  begun_ = false;
}

std::optional<Revolution> Vlp16Revolutions::take() {
  if (ended_.empty()) {
    return std::nullopt;
  }
  std::optional<Revolution> revolution = std::move(ended_.front());
  ended_.pop_front();
  return revolution;
}

void Vlp16Revolutions::add_sequence(const Vlp16Sequence& sequence, bool dual,
                                    std::int64_t stamp_ns) {
  current_.turned_deg += 0.01 * sequence.azimuth_step;
  // The azimuth of each laser from the one before, by the turn between two firings.
  double cosine = std::cos(sequence.azimuth * kUnit);
  double sine = std::sin(sequence.azimuth * kUnit);
  const double turn = sequence.azimuth_step * kUnit * vlp16::kLaserNs / vlp16::kSequenceNs;
  const double turn_cosine = std::cos(turn);
  const double turn_sine = std::sin(turn);
  const auto since_start = static_cast<std::int32_t>(stamp_ns - current_.scan.stamp_ns);
  for (int laser = 0; laser < vlp16::kLasers; ++laser) {
    const auto id = static_cast<std::size_t>(laser);
    const std::int32_t time_ns = since_start + laser * static_cast<std::int32_t>(vlp16::kLaserNs);
    const Vlp16Return last = sequence.first[id];
    const Vlp16Return other = sequence.second[id];
    // Where the last return is the strongest, the other block holds the second strongest.
    const bool other_is_strongest =
        dual && other.distance != 0 && other.reflectivity >= last.reflectivity;
    if (!dual || choice_ == ReturnChoice::kLast) {
      add_point(laser, last, cosine, sine, time_ns);
    } else if (choice_ == ReturnChoice::kStrongest) {
      add_point(laser, other_is_strongest || last.distance == 0 ? other : last, cosine, sine,
                time_ns);
    } else {
      add_point(laser, last, cosine, sine, time_ns);
      if (other.distance != last.distance) {
        add_point(laser, other, cosine, sine, time_ns);
      }
    }
    const double next_cosine = cosine * turn_cosine - sine * turn_sine;
    sine = sine * turn_cosine + cosine * turn_sine;
    cosine = next_cosine;
  }
}

void Vlp16Revolutions::add_point(int laser, Vlp16Return measured, double cosine, double sine,
                                 std::int32_t time_ns) {
  if (measured.distance == 0) {
    return;
  }
  const auto id = static_cast<std::size_t>(laser);
  const Laser& of = lasers_[id];
  const double distance = vlp16::kDistanceUnit * measured.distance;
  const double horizontal = distance * of.cosine;
  Scan& scan = current_.scan;
  scan.points.emplace_back(static_cast<float>(horizontal * cosine),
                           static_cast<float>(-horizontal * sine),
                           static_cast<float>(distance * of.sine + of.height));
  scan.intensities.push_back(measured.reflectivity);
  scan.times_ns.push_back(time_ns);
  scan.rings.push_back(vlp16::kRing[id]);
}

}  // namespace surefoot::dataset
