// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/sensor_clock.hpp"

#include <cstdlib>

#include "io/decimal_time.hpp"

namespace surefoot::io {
namespace {

using sensors::TimeBase;

constexpr std::int64_t kHourNs = 3'600'000'000'000;
constexpr std::int64_t kAgreeNs = 2'000'000'000;
constexpr std::int64_t kSetBackNs = 100'000'000;
// Times since the epoch: from September 2001 to August 2112. Smaller ones count from the sensor's
// start; there are no larger ones.
constexpr std::int64_t kEpochLeastNs = 1'000'000'000'000'000'000;
constexpr std::int64_t kGreatestNs = 4'500'000'000'000'000'000;

// `difference` plus the whole hours that bring it nearest to `target`.
std::int64_t nearest_by_hours(std::int64_t difference, std::int64_t target) {
  std::int64_t rest = (target - difference) % kHourNs;  // in (-1 h, 1 h)
  if (rest > kHourNs / 2) {
    rest -= kHourNs;
  } else if (rest < -kHourNs / 2) {
    rest += kHourNs;
  }
  return target - rest;
}

}  // namespace

SensorClock::Reading SensorClock::start(std::int64_t time_ns, TimeBase base,
                                        std::int64_t arrival_ns) {
  started_ = true;
  const bool past_hour = base == TimeBase::hour;
  const std::int64_t by_sensor = past_hour ? nearest_by_hours(time_ns, arrival_ns) : time_ns;
  const std::int64_t difference = by_sensor - arrival_ns;
  const std::string seconds = format_seconds(difference);
  if (!past_hour && time_ns >= kEpochLeastNs) {
    source_ = "the sensor's own time since the epoch (GPS or PTP)";
    note_ = "stamps: " + source_ + "; it differs from the capture's clock by " + seconds + " s";
    last_stamp_ns_ = by_sensor;
  } else if (std::abs(difference) <= kAgreeNs) {
    source_ = past_hour ? "the sensor's time past the hour" : "the sensor's clock";
    note_ = "stamps: " + source_ + ", the hour from the capture's clock (they differ by " +
            seconds + " s)";
    last_stamp_ns_ = by_sensor;
  } else {
    source_ = "the sensor's clock from the capture's start on";
    note_ = past_hour
                ? "stamps: the sensor's time past the hour and the capture's clock differ by " +
                      seconds +
                      " s; the first packet has the capture's time, the others follow by the "
                      "sensor's clock"
                : "stamps: the sensor counts from its own start (no GPS or PTP); the first packet "
                  "has the capture's time, the others follow by the sensor's clock";
    last_stamp_ns_ = arrival_ns;
  }
  return {last_stamp_ns_, 0, false};
}

/// From the last packet to the next; none where that is late, or came before.
std::optional<SensorClock::Reading> SensorClock::go_on(std::int64_t time_ns, bool past_hour,
                                                       std::int64_t arrival_ns) const {
  const std::int64_t by_arrival = arrival_ns - last_arrival_ns_;
  const bool receiver_set_back = by_arrival < -kSetBackNs;
  std::int64_t by_sensor = time_ns - last_time_ns_;
  if (past_hour) by_sensor = nearest_by_hours(by_sensor, receiver_set_back ? 0 : by_arrival);
  const bool is_late = by_sensor <= 0 && by_sensor >= -kSetBackNs && by_arrival <= kSetBackNs;
  if (is_late) return std::nullopt;
  Reading reading;
  // Whose next packet follows shortly was not set, whatever the receiver's clock says.
  const bool follows = by_sensor > 0 && by_sensor <= kAgreeNs;
  const bool set_back = by_sensor <= 0 && (receiver_set_back || by_arrival > kSetBackNs);
  reading.jumped = set_back || (!follows && std::abs(by_sensor - by_arrival) > kAgreeNs);
  reading.since_last_ns = !reading.jumped     ? by_sensor
                          : receiver_set_back ? last_step_ns_
                                              : by_arrival;
  const std::int64_t most = kGreatestNs - last_stamp_ns_;
  if (reading.since_last_ns <= 0 || reading.since_last_ns > most) return std::nullopt;
  reading.stamp_ns = last_stamp_ns_ + reading.since_last_ns;
  return reading;
}

std::optional<SensorClock::Reading> SensorClock::read(std::int64_t time_ns, TimeBase base,
                                                      std::int64_t arrival_ns) {
  const auto is_time = [](std::int64_t ns) { return ns >= 0 && ns <= kGreatestNs; };
  if (!is_time(time_ns) || arrival_ns < -kGreatestNs || arrival_ns > kGreatestNs) {
    return std::nullopt;
  }
  const bool past_hour = base == TimeBase::hour;
  time_ns = past_hour ? time_ns % kHourNs : time_ns;
  std::optional<Reading> reading;
  if (!started_) {
    reading = start(time_ns, base, arrival_ns);
  } else {
    reading = go_on(time_ns, past_hour, arrival_ns);
    if (!reading) return std::nullopt;
    last_step_ns_ = reading->since_last_ns;
    last_stamp_ns_ = reading->stamp_ns;
  }
  last_time_ns_ = time_ns;
  last_arrival_ns_ = arrival_ns;
  return reading;
}

std::optional<std::int64_t> SensorClock::stamp_before_last(std::int64_t time_ns,
                                                           TimeBase base) const {
  if (!started_ || time_ns < 0 || time_ns > kGreatestNs) return std::nullopt;
  const std::int64_t step = base == TimeBase::hour
                                ? nearest_by_hours(time_ns % kHourNs - last_time_ns_, 0)
                                : time_ns - last_time_ns_;
  if (step >= 0 || step < -kSetBackNs) return std::nullopt;
  return last_stamp_ns_ + step;
}

}  // namespace surefoot::io
