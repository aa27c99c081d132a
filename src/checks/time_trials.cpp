// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "checks/time_trials.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "checks/map_blur.hpp"
#include "io/point_time_watch.hpp"
#include "io/recording_summary.hpp"
#include "surefoot/odometry.hpp"

namespace surefoot::checks {
namespace {

// So unlikely must chance be before the motion is said to have decided.
constexpr double kUnlikely = 0.001;

struct Facts {
  const char* name;
  const char* flags;
};
Facts facts_of(TimeReading reading) {
  switch (reading) {
    case TimeReading::as_read:
      return {"as they are read", ""};
    case TimeReading::backward:
      return {"counted back from the stamp", "--point-times backward"};
    case TimeReading::none:
      return {"one instant for all", "--point-times none"};
    case TimeReading::clockwise_front:
      return {"clockwise from ahead", "--derive-times azimuth --spin clockwise --cut 0"};
    case TimeReading::clockwise_behind:
      return {"clockwise from behind", "--derive-times azimuth --spin clockwise --cut 180"};
    case TimeReading::counterclockwise_front:
      return {"counter-clockwise from ahead",
              "--derive-times azimuth --spin counterclockwise --cut 0"};
    case TimeReading::counterclockwise_behind:
      return {"counter-clockwise from behind",
              "--derive-times azimuth --spin counterclockwise --cut 180"};
  }
  return {"", ""};
}

Scan read_as(Scan scan, TimeReading reading, std::int64_t period_ns) {
  io::SweepTiming sweep;
  sweep.period_ns = period_ns;
  switch (reading) {
    case TimeReading::as_read:
      return scan;
    case TimeReading::backward:
      io::count_backward(scan);
      return scan;
    case TimeReading::none:
      scan.times_ns.clear();
      return scan;
    case TimeReading::clockwise_front:
    case TimeReading::clockwise_behind:
      sweep.spin = io::Spin::clockwise;
      break;
    case TimeReading::counterclockwise_front:
    case TimeReading::counterclockwise_behind:
      sweep.spin = io::Spin::counterclockwise;
      break;
  }
  const bool behind =
      reading == TimeReading::clockwise_behind || reading == TimeReading::counterclockwise_behind;
  sweep.cut_deg = behind ? 180.0 : 0.0;
  io::derive_times(scan, sweep);
  return scan;
}

TimeTrial run(const std::vector<Scan>& scans, TimeReading reading, std::int64_t period_ns,
              int threads) {
  TimeTrial trial;
  trial.reading = reading;
  Odometry odometry(Config{}, threads);
  MapBlur map;
  std::vector<double> known;
  for (const Scan& scan : scans) {
    const Estimate estimate = odometry.add_scan(read_as(scan, reading, period_ns));
    trial.blur.push_back(std::numeric_limits<double>::quiet_NaN());
    const bool anew = estimate.status == Status::first_scan && !trial.trajectory.empty();
    if (!estimate.trusted() || anew) {
      ++trial.untrusted;
      continue;
    }
    trial.trajectory.push_back({estimate.stamp_ns, estimate.T_world_lidar});
    const auto blur = map.add(odometry.deskewed_scan().points, estimate.T_world_lidar);
    if (!blur) continue;
    trial.blur.back() = *blur;
    known.push_back(*blur);
  }
  trial.middle_blur = io::spread_of(known).median;
  return trial;
}

// Scan by scan: what the scene makes of a scan's blur is the same for both.
void count_against(const TimeTrial& first, TimeTrial& trial) {
  for (std::size_t i = 0; i < trial.blur.size(); ++i) {
    trial.worse += trial.blur[i] > first.blur[i] ? 1 : 0;
    trial.better += trial.blur[i] < first.blur[i] ? 1 : 0;
  }
  trial.chance = chance_of(trial.worse, trial.better);
}

std::vector<TimeReading> readings_for(const std::vector<Scan>& scans, bool looks_around) {
  const bool timed = std::any_of(scans.begin(), scans.end(), [](const Scan& scan) {
    return io::point_times_of(scan) == io::PointTimes::there;
  });
  if (timed) return {TimeReading::as_read, TimeReading::backward, TimeReading::none};
  if (!looks_around) return {TimeReading::as_read};
  return {TimeReading::as_read, TimeReading::clockwise_front, TimeReading::clockwise_behind,
          TimeReading::counterclockwise_front, TimeReading::counterclockwise_behind};
}

// A map that is as sharp but for this share tells nothing, however often the one is the sharper: so
// are those of a sensor that stands, by what its noise happens to be.
constexpr double kLeastEffect = 0.02;

bool is_sharper(const TimeTrial& one, const TimeTrial& other) {
  return one.middle_blur < (1.0 - kLeastEffect) * other.middle_blur;
}

}  // namespace

const char* name_of(TimeReading reading) { return facts_of(reading).name; }
const char* flags_of(TimeReading reading) { return facts_of(reading).flags; }

void choose(TimeTrials& result) {
  const TimeTrial& first = result.trials.front();
  bool first_wins = result.trials.size() > 1;
  for (std::size_t i = 1; i < result.trials.size(); ++i) {
    const TimeTrial& trial = result.trials[i];
    const bool unlikely = trial.chance < kUnlikely;
    first_wins = first_wins && unlikely && trial.worse > trial.better && is_sharper(first, trial);
    const double best = result.trials[result.preferred].middle_blur;
    const bool wins = unlikely && trial.better > trial.worse && is_sharper(trial, first);
    if (wins && trial.middle_blur < best) result.preferred = i;
  }
  result.decided = first_wins || result.preferred > 0;
}

double chance_of(std::size_t a, std::size_t b) {
  const std::size_t n = a + b, least = std::min(a, b);
  double sum = 0.0;
  for (std::size_t k = 0; k <= least; ++k) {
    const auto real = [](std::size_t value) { return static_cast<double>(value); };
    sum += std::exp(std::lgamma(real(n) + 1.0) - std::lgamma(real(k) + 1.0) -
                    std::lgamma(real(n - k) + 1.0) - real(n) * std::log(2.0));
  }
  return std::min(1.0, 2.0 * sum);
}

TimeTrials try_times(const std::vector<Scan>& scans, std::int64_t period_ns, bool looks_around,
                     int threads) {
  TimeTrials result;
  result.scans = scans.size();
  for (const TimeReading reading : readings_for(scans, looks_around)) {
    result.trials.push_back(run(scans, reading, period_ns, threads));
    count_against(result.trials.front(), result.trials.back());
  }
  choose(result);
  return result;
}

}  // namespace surefoot::checks
