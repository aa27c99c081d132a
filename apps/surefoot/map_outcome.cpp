// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "map_outcome.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "io/counted.hpp"
#include "runs/run_files.hpp"

namespace surefoot::app {

namespace {

void print_map_outcome(const runs::MapOutcome& outcome) {
  fmt::print("loops: {} taken of {} compared, {} of way; poses moved by up to {:.2f} m\n",
             outcome.taken, io::counted(outcome.candidates, "place"),
             io::counted(outcome.pieces, "piece"), outcome.moved);
  if (outcome.score) {
    fmt::print("against the truth: {} of {} found, {} of {} false\n", outcome.score->found,
               io::counted(outcome.score->revisits, "revisit"), outcome.score->taken_false,
               io::counted(outcome.taken, "loop"));
  }
  if (!outcome.unjudged.empty()) fmt::print("loops are not judged: {}\n", outcome.unjudged);
  if (!outcome.join || !outcome.join->joined) return;
  fmt::print(
      "the map is continued: {} to it of {} compared, {} seen by both; {}; {} of way in all\n",
      io::counted(outcome.join->taken, "loop"), io::counted(outcome.join->compared, "place"),
      io::counted(outcome.join->near, "place"), place_in_map(*outcome.join->begin),
      io::counted(outcome.join->pieces, "piece"));
}

void print_localization(const runs::LocalizationOutcome& outcome) {
  if (!outcome.first_found) {
    fmt::print("not found in the map: {}\n", outcome.message);
    return;
  }
  fmt::print("found in the map after {:.1f} s; place known for {} of {}\n", *outcome.first_found,
             outcome.found, io::counted(outcome.scans, "scan"));
}

}  // namespace

std::string place_in_map(const Pose& begin) {
  const Eigen::Vector3d& t = begin.translation;
  const double yaw = roll_pitch_yaw(begin.rotation).z() * 180.0 / std::numbers::pi;
  const auto tenths = [](double value) { return std::round(10.0 * value) / 10.0 + 0.0; };  // no -0
  return fmt::format("it begins at {:.1f}, {:.1f}, {:.1f} m, heading {:.0f} deg", tenths(t.x()),
                     tenths(t.y()), tenths(t.z()), std::round(yaw) + 0.0);
}

bool say_if_apart(const runs::RunOutcome& outcome) {
  if (!outcome.map || !outcome.map->join || outcome.map->join->joined) return false;
  fmt::print(stderr,
             "surefoot: the map is not continued: {}; this run's own map is map_apart.surefoot in "
             "{}, map_loops.csv says what was compared\n",
             outcome.map->join->message, outcome.folder.string());
  return true;
}

void print_frames(const runs::RunOutcome& outcome) {
  if (outcome.segments > 1) {
    fmt::print("  {} segments, each in a frame of its own: {}N.tum\n", outcome.segments,
               runs::kSegmentFiles);
  }
  if (outcome.map) print_map_outcome(*outcome.map);
  if (outcome.localization) print_localization(*outcome.localization);
}

}  // namespace surefoot::app
