// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The module's parts, one file each. Types that several of them know stand in headers of their own.
#pragma once

#include <pybind11/pybind11.h>

namespace surefoot::python {

namespace py = pybind11;

/// __iter__ of what __getitem__ gives one by one: Python would do without, collections.abc and type
/// checkers do not.
inline py::iterator iterate_by_index(const py::object& self) {
  return py::reinterpret_steal<py::iterator>(PySeqIter_New(self.ptr()));
}

void bind_errors(py::module_& module);
void bind_config(py::module_& module);
void bind_scan(py::module_& module);
void bind_trajectory(py::module_& module);
void bind_estimate(py::module_& module);
void bind_odometry(py::module_& module);
void bind_mapping(py::module_& module);
void bind_recording(py::module_& module);
void bind_datasets(py::module_& module);
void bind_evaluation(py::module_& module);
void bind_run(py::module_& module);
#ifdef SUREFOOT_HAS_SIMULATION
void bind_simulation(py::module_& module);
#endif

}  // namespace surefoot::python
