// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// In place of pose_graph_solver.cpp where the program is built without Ceres.
#include <stdexcept>

#include "mapping/pose_graph_solver.hpp"

namespace surefoot::mapping {

bool has_solver() { return false; }

double solve(PoseGraph& /*graph*/, const std::vector<double>& /*weights*/, int /*max_iterations*/) {
  throw std::runtime_error(
      "this program was built without Ceres (SUREFOOT_CERES): loops cannot be closed");
}

}  // namespace surefoot::mapping
