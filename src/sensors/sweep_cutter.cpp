// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "sensors/sweep_cutter.hpp"

#include <algorithm>

namespace surefoot::sensors {
namespace {

// The head's azimuth is measured; it may go back by less than this without a new turn [deg].
constexpr double kJitterDeg = 1.0;
// What may be missing of a whole sweep [deg].
constexpr double kSlackDeg = 1.0;
// Sweeps that end by time: as long as a turn of the usual spinning sensor.
constexpr std::int64_t kSweepNs = 100'000'000;
// The slowest head (300 rpm) turns in 0.2 s; one that stands must not fill the memory.
constexpr std::int64_t kLongestNs = 500'000'000;
// Nor may packets of a clock that hardly moves. The largest sweeps have half a million points.
constexpr std::size_t kMostPoints = 4'000'000;

/// Appends a firing's points, which are those of the packet from `next` on; `fired_ns` is counted
/// from the scan's stamp. Returns where the next firing's begin.
std::size_t append_points(Scan& scan, const Firings& packet, std::size_t next, const Firing& firing,
                          std::int32_t fired_ns) {
  for (; next < firing.end; ++next) {
    const FiringPoint& point = packet.points[next];
    scan.points.push_back(point.position);
    scan.intensities.push_back(point.intensity);
    scan.times_ns.push_back(fired_ns + point.offset_ns);
    scan.rings.push_back(point.ring);
  }
  return next;
}

}  // namespace

SweepCutter::SweepCutter(SweepEnd end, double cut_azimuth_deg, double sweep_deg)
    : end_(end), cut_deg_(cut_azimuth_deg), sweep_deg_(sweep_deg) {}

void SweepCutter::add(const Firings& packet, std::int64_t stamp_ns, std::int64_t since_last_ns) {
  const std::int64_t turn_ns = end_ == SweepEnd::time ? kSweepNs : turn_ns_;
  if (turn_ns > 0 && since_last_ns > turn_ns) {
    finish();  // the azimuth alone would not show that whole turns are missing
  }
  std::size_t next = 0;
  for (const Firing& firing : packet.firings) {
    const std::int64_t at_ns = stamp_ns + firing.offset_ns;
    const double past_cut_deg =
        firing.azimuth_deg - cut_deg_ + (firing.azimuth_deg < cut_deg_ ? 360.0 : 0.0);
    if (starts_sweep(firing, past_cut_deg, at_ns)) {
      current_.shares_packet = &firing != &packet.firings.front();
      finish();
      begin(at_ns, firing.frame);
    }
    last_past_cut_deg_ = past_cut_deg;
    if (firing.turned_deg > 0.0) {
      turn_ns_ = static_cast<std::int64_t>(static_cast<double>(firing.duration_ns) * 360.0 /
                                           firing.turned_deg);
    }
    current_.turned_deg += firing.turned_deg;
    current_.duration_ns = at_ns + firing.duration_ns - current_.scan.stamp_ns;
    next = append_points(current_.scan, packet, next, firing,
                         static_cast<std::int32_t>(at_ns - current_.scan.stamp_ns));
  }
}

bool SweepCutter::add_late(const Firings& packet, std::int64_t stamp_ns) {
  if (!begun_) return false;
  for (const Firing& firing : packet.firings) {
    const std::int64_t lasted_ns = stamp_ns + firing.offset_ns - current_.scan.stamp_ns;
    if (lasted_ns < 0 || lasted_ns > kLongestNs) return false;
  }
  Scan& scan = current_.scan;
  Scan late;
  std::size_t next = 0;
  for (const Firing& firing : packet.firings) {
    current_.turned_deg += firing.turned_deg;
    const std::int64_t at_ns = stamp_ns + firing.offset_ns;
    next =
        append_points(late, packet, next, firing, static_cast<std::int32_t>(at_ns - scan.stamp_ns));
  }
  if (late.points.empty()) return true;
  // Before those of the packets that came too soon.
  std::size_t at = scan.times_ns.size();
  while (at > 0 && scan.times_ns[at - 1] > late.times_ns.back()) --at;
  const auto insert = [at](auto& values, const auto& more) {
    values.insert(values.begin() + static_cast<std::ptrdiff_t>(at), more.begin(), more.end());
  };
  insert(scan.points, late.points);
  insert(scan.intensities, late.intensities);
  insert(scan.times_ns, late.times_ns);
  insert(scan.rings, late.rings);
  return true;
}

bool SweepCutter::starts_sweep(const Firing& firing, double past_cut_deg,
                               std::int64_t stamp_ns) const {
  const std::int64_t lasted_ns = stamp_ns - current_.scan.stamp_ns;
  if (!begun_ || lasted_ns > kLongestNs || lasted_ns < -kLongestNs ||
      current_.scan.points.size() > kMostPoints) {
    return true;
  }
  switch (end_) {
    case SweepEnd::azimuth:
      return past_cut_deg < last_past_cut_deg_ - kJitterDeg;
    case SweepEnd::frame:
      return firing.frame != frame_;
    case SweepEnd::time:
      return lasted_ns >= kSweepNs;
  }
  return false;
}

void SweepCutter::begin(std::int64_t stamp_ns, std::uint32_t frame) {
  begun_ = true;
  frame_ = frame;
  current_ = {};
  current_.scan.stamp_ns = stamp_ns;
  current_.scan.points.reserve(usual_points_);
  current_.scan.intensities.reserve(usual_points_);
  current_.scan.times_ns.reserve(usual_points_);
  current_.scan.rings.reserve(usual_points_);
}

bool SweepCutter::is_whole(const Sweep& sweep) const {
  return end_ == SweepEnd::time ? sweep.duration_ns > kSweepNs * 99 / 100
                                : sweep.turned_deg > sweep_deg_ - kSlackDeg;
}

void SweepCutter::finish() {
  current_.whole = is_whole(current_);
  // A few firings that met nothing fill a recording's last packet; they are no scan.
  if (begun_ && (current_.whole || !current_.scan.points.empty())) {
    usual_points_ = current_.scan.points.size() + current_.scan.points.size() / 8;
    ended_.push_back(std::move(current_));
  }
  begun_ = false;
}

std::optional<Sweep> SweepCutter::take() {
  if (ended_.empty()) {
    return std::nullopt;
  }
  std::optional<Sweep> sweep = std::move(ended_.front());
  ended_.pop_front();
  return sweep;
}

}  // namespace surefoot::sensors
