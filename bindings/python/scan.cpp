// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Scans from arrays. What has the right type already is looked at where it lies, with any stride:
// a column of a structured array, every other row, a message's buffer.
#include "scan.hpp"

#include <pybind11/stl.h>

#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "arrays.hpp"
#include "bindings.hpp"
#include "cloud.hpp"
#include "numbers.hpp"

namespace surefoot::python {

namespace {

template <typename T>
bindings::StridedView<T> column(const py::array& array) {
  if (array.size() == 0) return {};
  return {array.data(), static_cast<std::size_t>(array.shape(0)), array.strides(0)};
}

template <typename Number>
py::array empty_column() {
  return py::array_t<Number>(0);
}

/// One value a point, of this type: as it lies, or converted.
template <typename Number>
py::array column_of(const py::object& given, const char* what, py::ssize_t points) {
  if (given.is_none()) return empty_column<Number>();
  const py::array array = numbers_of<Number>(given, what);
  if (array.ndim() != 1 || (array.shape(0) != points && array.shape(0) != 0)) {
    throw std::invalid_argument(std::string(what) + ": got an array " + shape_of(array) +
                                ", expected (" + std::to_string(points) + ",)");
  }
  return array;
}

py::array points_of(const py::object& given) {
  if (py::isinstance<py::array>(given) && !py::array(given).dtype().attr("names").is_none()) {
    throw std::invalid_argument(
        "points: got a structured array, expected (N, 3); Scan.from_cloud takes it");
  }
  const py::array array = numbers_of<float>(given, "points");
  if (array.ndim() != 2 || array.shape(1) != 3) {
    throw std::invalid_argument("points: got an array " + shape_of(array) + ", expected (N, 3)");
  }
  if (array.strides(1) == static_cast<py::ssize_t>(sizeof(float))) return array;
  return py::array_t<float, py::array::c_style | py::array::forcecast>::ensure(given);
}

/// Seconds after the stamp, rounded to nanoseconds.
py::array times_of_seconds(const py::object& given, py::ssize_t points) {
  const py::array seconds = column_of<double>(given, "times", points);
  std::vector<std::int32_t> times_ns(static_cast<std::size_t>(seconds.shape(0)));
  for (std::size_t i = 0; i < times_ns.size(); ++i) {
    const double ns = 1e9 * column<double>(seconds)[i];
    if (!(std::abs(ns) <= static_cast<double>(std::numeric_limits<std::int32_t>::max()))) {
      throw std::invalid_argument("times: got " + std::to_string(1e-9 * ns) +
                                  " s, expected seconds after the stamp, at most 2.1 away");
    }
    times_ns[i] = static_cast<std::int32_t>(std::llrint(ns));
  }
  return array_of(std::move(times_ns));
}

ArrayScan make_scan(const py::object& points, std::int64_t stamp_ns, const py::object& times_ns,
                    const py::object& times, const py::object& intensities,
                    const py::object& rings) try {
  if (!times_ns.is_none() && !times.is_none()) {
    throw std::invalid_argument("got both times_ns and times, expected one of them");
  }
  ArrayScan scan;
  scan.stamp_ns = stamp_ns;
  scan.points = points_of(points);
  const py::ssize_t size = scan.points.shape(0);
  scan.times_ns = times.is_none() ? column_of<std::int32_t>(times_ns, "times_ns", size)
                                  : times_of_seconds(times, size);
  scan.intensities = column_of<float>(intensities, "intensities", size);
  scan.rings = column_of<std::uint16_t>(rings, "rings", size);
  return scan;
} catch (const std::invalid_argument& error) {  // one of many: which?
  throw std::invalid_argument("scan of stamp " + std::to_string(stamp_ns) + " ns: " + error.what());
}

}  // namespace

bindings::ScanView ArrayScan::view() const {
  bindings::ScanView view;
  view.stamp_ns = stamp_ns;
  view.points = column<Eigen::Vector3f>(points);
  view.times_ns = column<std::int32_t>(times_ns);
  view.intensities = column<float>(intensities);
  view.rings = column<std::uint16_t>(rings);
  return view;
}

ArrayScan array_scan(Scan scan) {
  ArrayScan result;
  result.stamp_ns = scan.stamp_ns;
  result.points = array_of(std::move(scan.points));
  result.times_ns = array_of(std::move(scan.times_ns));
  result.intensities = array_of(std::move(scan.intensities));
  result.rings = array_of(std::move(scan.rings));
  return result;
}

void bind_scan(py::module_& module) {
  py::class_<ArrayScan>(module, "Scan", R"(One sweep of a LiDAR: points with their instants.

Arrays of the types below are not copied, whatever their strides; others are converted. They must
stay as they are until the scan was used. Points that are NaN, infinite or within a millimetre of
zero are "no return".)")
      .def(py::init(&make_scan), py::arg("points"), py::kw_only(), py::arg("stamp_ns") = 0,
           py::arg("times_ns") = py::none(), py::arg("times") = py::none(),
           py::arg("intensities") = py::none(), py::arg("rings") = py::none(), R"(
points: (N, 3) float32 [m], LiDAR frame: x forward, y left, z up
stamp_ns: instant that the points' times count from [ns, the sensor's epoch]
times_ns: (N,) int32, each point's instant minus stamp_ns [ns]
times: (N,) the same in seconds, instead
intensities: (N,) float32, as the sensor gives them
rings: (N,) uint16, lasers counted from the lowest)")
      .def_static("from_cloud", &scan_of_cloud, py::arg("cloud"), py::arg("stamp_ns") = py::none(),
                  py::kw_only(), py::arg("time_field") = "", py::arg("time_unit") = "auto",
                  py::arg("time_reference") = "auto", py::arg("stamp_at") = "start", R"(
A scan of a structured array, such as a PointCloud2's: fields x, y, z and, by the names that drivers
use, intensity, ring and time. What the times mean is found from the values as the program does it,
or said: time_unit s, ms, us, ns; time_reference relative (to the stamp) or absolute; stamp_at start
or end. stamp_ns may be None where the times are absolute. Points are not copied where x, y, z are
float32 beside each other and the times, if any, int32 nanoseconds.)")
      .def_readwrite("stamp_ns", &ArrayScan::stamp_ns, "[ns] of the sensor's epoch.")
      .def_readonly("points", &ArrayScan::points, "(N, 3) float32 [m], LiDAR frame.")
      .def_readonly("times_ns", &ArrayScan::times_ns, "(N,) int32 [ns] after stamp_ns, or (0,).")
      .def_readonly("intensities", &ArrayScan::intensities, "(N,) float32, or (0,).")
      .def_readonly("rings", &ArrayScan::rings, "(N,) uint16, or (0,).")
      .def_readonly("name", &ArrayScan::name, "Of its file, or 'revolution 12'; may be empty.")
      .def_readonly("remark", &ArrayScan::remark, "What is odd about it: 'partial revolution ...'.")
      .def("__len__", [](const ArrayScan& self) { return self.points.shape(0); })
      .def("__repr__", [](const ArrayScan& self) {
        return "<Scan of " + std::to_string(self.points.shape(0)) + " points, stamp_ns " +
               std::to_string(self.stamp_ns) + (self.name.empty() ? ">" : ", " + self.name + ">");
      });
}

}  // namespace surefoot::python
