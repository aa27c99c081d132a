// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "dataset/sensor_clock.hpp"

#include <cstdlib>

#include "dataset/decimal_time.hpp"

namespace surefoot::dataset {
namespace {

constexpr std::int64_t kHourNs = 3'600'000'000'000;
constexpr std::int64_t kAgreeNs = 2'000'000'000;

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

SensorClock::Reading SensorClock::start(std::int64_t past_hour_ns, std::int64_t capture_ns) {
  started_ = true;
  const std::int64_t by_sensor = nearest_by_hours(past_hour_ns, capture_ns);
  const std::int64_t difference = by_sensor - capture_ns;
  const bool agree = std::abs(difference) <= kAgreeNs;
  last_stamp_ns_ = agree ? by_sensor : capture_ns;
  note_ = agree
              ? "stamps: the sensor's time past the hour, the hour from the capture's clock (they "
                "differ by " +
                    format_seconds(difference) + " s)"
              : "stamps: the sensor's time past the hour and the capture's clock differ by " +
                    format_seconds(difference) +
                    " s; the first packet has the capture's time, the others follow by the "
                    "sensor's clock";
  return {last_stamp_ns_, 0, false};
}

std::optional<SensorClock::Reading> SensorClock::read(std::uint32_t past_hour_us,
                                                      std::int64_t capture_ns) {
  const std::int64_t past_hour_ns = static_cast<std::int64_t>(past_hour_us) * 1000 % kHourNs;
  Reading reading;
  if (!started_) {
    reading = start(past_hour_ns, capture_ns);
  } else {
    const std::int64_t by_capture = capture_ns - last_capture_ns_;
    std::int64_t step = nearest_by_hours(past_hour_ns - last_past_hour_ns_, by_capture);
    reading.jumped = std::abs(step - by_capture) > kAgreeNs;
    step = reading.jumped ? by_capture : step;
    if (step <= 0) {
      return std::nullopt;
    }
    last_stamp_ns_ += step;
    reading.stamp_ns = last_stamp_ns_;
    reading.since_last_ns = step;
  }
  last_past_hour_ns_ = past_hour_ns;
  last_capture_ns_ = capture_ns;
  return reading;
}

}  // namespace surefoot::dataset
