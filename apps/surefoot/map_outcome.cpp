// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "map_outcome.hpp"

#include <fmt/format.h>

#include <numbers>

namespace surefoot::app {

std::string place_in_map(const Pose& begin) {
  const Eigen::Vector3d& t = begin.translation;
  const double yaw = roll_pitch_yaw(begin.rotation).z() * 180.0 / std::numbers::pi;
  return fmt::format("it begins at {:.1f}, {:.1f}, {:.1f} m, heading {:.0f} deg", t.x(), t.y(),
                     t.z(), yaw);
}

void print_map_outcome(const runs::MapOutcome& outcome) {
  fmt::print(
      "loops: {} taken of {} places compared, {} pieces of way; poses moved by up to {:.2f} m\n",
      outcome.taken, outcome.candidates, outcome.pieces, outcome.moved);
  if (outcome.score) {
    fmt::print("against the truth: {} of {} revisits found, {} of {} loops false\n",
               outcome.score->found, outcome.score->revisits, outcome.score->taken_false,
               outcome.taken);
  }
  if (!outcome.join || !outcome.join->joined) return;
  fmt::print(
      "the map is continued: {} loops to it of {} places compared, {} places seen by both; {}; "
      "{} pieces of way in all\n",
      outcome.join->taken, outcome.join->compared, outcome.join->near,
      place_in_map(*outcome.join->begin), outcome.join->pieces);
}

bool say_if_apart(const runs::RunOutcome& outcome) {
  if (!outcome.map || !outcome.map->join || outcome.map->join->joined) return false;
  fmt::print(stderr,
             "surefoot: the map is not continued: {}; this run's own map is map_apart.surefoot in "
             "{}, map_loops.csv says what was compared\n",
             outcome.map->join->message, outcome.folder.string());
  return true;
}

void print_localization(const runs::LocalizationOutcome& outcome) {
  if (!outcome.first_found) {
    fmt::print("not found in the map: {}\n", outcome.message);
    return;
  }
  fmt::print("found in the map after {:.1f} s; place known for {} of {} scans\n",
             *outcome.first_found, outcome.found, outcome.scans);
}

}  // namespace surefoot::app
