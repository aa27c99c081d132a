// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The module's parts, one file each. Types that several of them know stand in headers of their own.
#pragma once

#include <pybind11/pybind11.h>

namespace surefoot::python {

namespace py = pybind11;

void bind_errors(py::module_& module);
void bind_config(py::module_& module);
void bind_scan(py::module_& module);
void bind_trajectory(py::module_& module);
void bind_estimate(py::module_& module);
void bind_odometry(py::module_& module);
void bind_mapping(py::module_& module);
void bind_recording(py::module_& module);
void bind_evaluation(py::module_& module);
void bind_run(py::module_& module);
#ifdef SUREFOOT_HAS_SIMULATION
void bind_simulation(py::module_& module);
#endif

}  // namespace surefoot::python
