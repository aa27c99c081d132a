// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/packets/packet_scans.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "io/ascii_values.hpp"
#include "io/file_reader.hpp"
#include "sensors/sensor_list.hpp"

namespace surefoot::io {
namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) {
    text += (text.empty() ? "" : ", ") + word;
  }
  return text;
}

std::string remark_of(const sensors::Sweep& sweep, sensors::SweepEnd end) {
  char text[80];
  if (end == sensors::SweepEnd::time) {
    std::snprintf(text, sizeof(text), "partial sweep: firings over %.1f of 100 ms",
                  1e-6 * static_cast<double>(sweep.duration_ns));
  } else {
    std::snprintf(text, sizeof(text), "partial revolution: firings over %.1f of 360 deg",
                  sweep.turned_deg);
  }
  return text;
}

}  // namespace

PacketScans::PacketScans(const OpenOptions& options, std::string metadata) : options_(options) {
  if (!options_.sensor.empty() && !sensors::is_sensor_name(options_.sensor)) {
    throw ReadError("no sensor is called '" + options_.sensor +
                    "'; there are: " + joined(sensors::sensor_names()));
  }
  decoder_options_.returns = options_.dual_return;
  decoder_options_.beam_origins = options_.beam_origins;
  decoder_options_.metadata = std::move(metadata);
  if (!options_.calibration_file.empty()) {
    calibration_name_ = options_.calibration_file.string() + ": ";
    try {
      std::vector<std::byte> bytes;
      read_whole_file(options_.calibration_file, bytes);
      constexpr std::size_t kMostBytes = 4'000'000;
      if (bytes.size() > kMostBytes) {
        throw ReadError("it has " + std::to_string(bytes.size()) +
                        " bytes; expected a sensor's calibration or metadata");
      }
      decoder_options_.calibration = text_of(bytes);
    } catch (const ReadError& error) {
      throw ReadError(calibration_name_ + error.what());
    }
  }
}

PacketScans::~PacketScans() = default;

bool PacketScans::pending() const { return cutter_ && cutter_->pending(); }
std::string PacketScans::sensor() const { return decoder_ ? decoder_->sensor() : ""; }
std::string PacketScans::return_mode() const { return decoder_ ? decoder_->return_mode() : ""; }

PacketUse PacketScans::add(std::int64_t arrival_ns, std::span<const std::byte> payload) {
  if (!decoder_) {
    try {
      decoder_ = sensors::find_decoder(payload, options_.sensor, decoder_options_, reason_);
    } catch (const sensors::CalibrationError& error) {
      throw ReadError(calibration_name_ + error.what());
    }
    if (!decoder_) {
      return PacketUse::other;
    }
    note_other_name(payload);
  }
  const sensors::PacketKind kind = decoder_->decode(payload, firings_);
  if (kind != sensors::PacketKind::data) {
    return kind == sensors::PacketKind::other ? PacketUse::other : PacketUse::malformed;
  }
  const std::optional<SensorClock::Reading> reading =
      clock_.read(firings_.time_ns, firings_.base, arrival_ns);
  if (!reading) {
    return add_late();
  }
  if (!cutter_) {
    begin();
  }
  if (reading->jumped) {
    cutter_->finish();
    note_jump();
    last_number_.reset();
    holes_.clear();
  } else {
    count_lost(*reading);
  }
  last_period_ns_ = firings_.period_ns;
  if (firings_.numbers > 0) {
    last_number_ = firings_.number;
  }
  cutter_->add(firings_, reading->stamp_ns, reading->since_last_ns);
  return PacketUse::used;
}

// What is asked for is done, but not without a word where the packets contradict it.
void PacketScans::note_other_name(std::span<const std::byte> payload) {
  const std::string named = sensors::named_sensor(payload);
  if (options_.sensor.empty() || named.empty() || named == decoder_->sensor()) return;
  notes_.push_back("the packets name a " + named + "; they are read as a " + decoder_->sensor() +
                   "'s, as was asked");
}

// A clock that is set at every packet has as many of them.
void PacketScans::note_jump() {
  constexpr std::size_t kMostNoted = 10;
  if (++jumps_ > kMostNoted) return;
  notes_.push_back(
      "the sensor's clock was set during revolution " + std::to_string(next_) +
      "; the capture's clock bridges it" +
      (jumps_ == kMostNoted ? "; where it was set again after that is not listed" : ""));
}

void PacketScans::begin() {
  cutter_.emplace(decoder_->sweep_end(), options_.cut_azimuth_deg, decoder_->sweep_deg());
  notes_.push_back("return mode: " + decoder_->return_mode());
  notes_.push_back(clock_.note());
}

// By the packets' numbers where they have some, else by their times.
void PacketScans::count_lost(const SensorClock::Reading& reading) {
  // More than an hour of packets is not lost but counted anew.
  constexpr std::uint64_t kMost = 20'000'000;
  std::uint64_t missing = 0;
  if (firings_.numbers > 0 && last_number_) {
    const std::uint64_t step =
        (firings_.number + firings_.numbers - *last_number_ % firings_.numbers) % firings_.numbers;
    missing = step > 0 ? step - 1 : 0;
  } else if (firings_.numbers == 0 && last_period_ns_ > 0) {
    const double packets = std::round(static_cast<double>(reading.since_last_ns) /
                                      static_cast<double>(last_period_ns_));
    missing = packets > 1.0 ? static_cast<std::uint64_t>(packets) - 1 : 0;
  }
  if (missing == 0 || missing > kMost) return;
  lost_ += missing;
  constexpr std::size_t kMostHoles = 8;
  holes_.push_back({reading.stamp_ns - reading.since_last_ns, reading.stamp_ns, missing, {}});
  if (holes_.size() > kMostHoles) holes_.pop_front();
}

// Not lost, but overtaken on its way; one that was used already is no such packet.
PacketUse PacketScans::add_late() {
  const std::optional<std::int64_t> stamp_ns =
      clock_.stamp_before_last(firings_.time_ns, firings_.base);
  if (!stamp_ns || !cutter_) return PacketUse::late;
  for (Hole& hole : holes_) {
    const bool is_in = *stamp_ns > hole.after_ns && *stamp_ns < hole.before_ns;
    const auto& filled = hole.filled_ns;
    if (!is_in || filled.size() == hole.missing ||
        std::find(filled.begin(), filled.end(), *stamp_ns) != filled.end() ||
        !cutter_->add_late(firings_, *stamp_ns)) {
      continue;
    }
    hole.filled_ns.push_back(*stamp_ns);
    --lost_;
    if (++reordered_ == 1) {
      notes_.push_back("packets came in another order than they were sent, first in revolution " +
                       std::to_string(next_) + "; they are put where they belong");
    }
    return PacketUse::used;
  }
  return PacketUse::late;
}

void PacketScans::finish() {
  if (cutter_) {
    cutter_->finish();
  }
}

std::optional<ScanItem> PacketScans::take() {
  std::optional<sensors::Sweep> sweep = cutter_ ? cutter_->take() : std::nullopt;
  if (!sweep) {
    return std::nullopt;
  }
  ScanItem item;
  item.name = "revolution " + std::to_string(next_++);
  item.layout = decoder_->sensor() + " packets";
  if (!sweep->whole) {
    item.remark = remark_of(*sweep, decoder_->sweep_end());
  }
  shared_packet_ = sweep->shares_packet;
  item.scan = std::move(sweep->scan);
  return item;
}

}  // namespace surefoot::io
