// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/idle_options.hpp"

namespace surefoot::io {

std::vector<std::string> idle_options(const OpenOptions& options, const RecordingKind& kind) {
  const OpenOptions usual;
  const auto [as_bag, packets] = kind;
  const bool files = !as_bag && !packets;
  std::vector<std::string> notes;
  const auto idle = [&](bool given, const char* option, const char* of) {
    if (given) notes.push_back(std::string(option) + " counts for nothing here: it is for " + of);
  };
  if (!as_bag) idle(!options.topic.empty(), "--topic", "bags");
  if (!files) idle(!options.stamps_file.empty(), "--stamps", "folders of scans");
  if (!files) idle(!options.format.empty(), "--format", "folders of scans");
  if (!files) idle(options.kitti_hdl64_correction, "--kitti-correction", "files of scans");
  if (as_bag || files) idle(options.udp_port != 0, "--udp-port", "captures");
  const bool derived = options.derive_times != DeriveTimes::no;
  const bool kept = options.time_direction != TimeDirection::none;
  const char* const of_times = "scans that keep their times, not --point-times none";
  if (!kept) idle(derived, "--derive-times", of_times);
  if (!derived) idle(options.spin != usual.spin, "--spin", "--derive-times");
  if (packets || !kept) {
    const char* const of = packets ? "points that come with their fields" : of_times;
    idle(!options.time_field.empty(), "--time-field", of);
    idle(options.time_unit != usual.time_unit, "--time-unit", of);
    idle(options.time_reference != usual.time_reference, "--time-reference", of);
  }
  if (!packets) {
    const char* const of = "a sensor's packets";
    idle(!options.sensor.empty(), "--sensor", of);
    idle(!options.calibration_file.empty(), "--calibration", of);
    idle(options.dual_return != usual.dual_return, "--return", of);
    idle(!options.beam_origins, "--no-vertical-correction", of);
    idle(options.cut_azimuth_deg != 0.0 && !derived, "--cut", of);
  }
  return notes;
}

}  // namespace surefoot::io
