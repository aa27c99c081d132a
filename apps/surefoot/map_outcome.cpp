// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "map_outcome.hpp"

#include <fmt/format.h>

namespace surefoot::app {

void print_map_outcome(const runs::MapOutcome& outcome) {
  fmt::print(
      "loops: {} taken of {} places compared, {} pieces of way; poses moved by up to {:.2f} m\n",
      outcome.taken, outcome.candidates, outcome.pieces, outcome.moved);
  if (!outcome.score) return;
  fmt::print("against the truth: {} of {} revisits found, {} of {} loops false\n",
             outcome.score->found, outcome.score->revisits, outcome.score->taken_false,
             outcome.taken);
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
