// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/numpy.h>

#include <cstdint>
#include <string>

#include "io/recording.hpp"
#include "shared/scan_view.hpp"
#include "surefoot/scan.hpp"

namespace surefoot::python {

namespace py = pybind11;

/// A scan whose arrays are numpy's: the caller's own, or those that a reader filled.
struct ArrayScan {
  std::int64_t stamp_ns = 0;
  py::array points;       ///< (N, 3) float32, x y z beside each other
  py::array times_ns;     ///< (N,) int32, or (0,)
  py::array intensities;  ///< (N,) float32, or (0,)
  py::array rings;        ///< (N,) uint16, or (0,)
  std::string name;
  std::string remark;

  /// Looks into the arrays. Needs no interpreter lock.
  [[nodiscard]] bindings::ScanView view() const;
};

/// Takes the scan's memory over.
[[nodiscard]] ArrayScan array_scan(Scan scan);

}  // namespace surefoot::python
