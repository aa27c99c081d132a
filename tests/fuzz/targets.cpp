// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "fuzz/targets.hpp"

namespace surefoot::fuzz {

std::vector<Target> targets() {
  std::vector<Target> all;
  for (const auto& some : {file_targets(), packet_targets(), bag_targets(), stamp_targets(),
                           program_targets(), map_targets()}) {
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

}  // namespace surefoot::fuzz
