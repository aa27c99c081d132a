// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "bindings.hpp"

PYBIND11_MODULE(_core, module) {
  using namespace surefoot::python;
  module.doc() = "LiDAR odometry for robots that walk: the compiled part of `surefoot`.";
  module.attr("__version__") = SUREFOOT_VERSION;
  bind_errors(module);
  bind_config(module);
  bind_scan(module);
  bind_trajectory(module);
  bind_estimate(module);
  bind_odometry(module);
  bind_mapping(module);
  bind_recording(module);
  bind_datasets(module);
  bind_evaluation(module);
  bind_run(module);
#ifdef SUREFOOT_HAS_SIMULATION
  bind_simulation(module);
#endif
}
