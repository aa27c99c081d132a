// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "surefoot/odometry.hpp"

#include <pybind11/stl.h>

#include <memory>
#include <mutex>
#include <optional>

#include "arrays.hpp"
#include "bindings.hpp"
#include "config.hpp"
#include "poses.hpp"
#include "scan.hpp"

namespace surefoot::python {

namespace {

/// An Odometry that threads of Python may share: one at a time has it.
struct SharedOdometry {
  SharedOdometry(const NamedConfig& named, int threads, const std::optional<Matrix4>& T_world_start)
      : config(named),
        odometry(named.config, threads, T_world_start ? pose_of(*T_world_start) : Pose{}) {}

  NamedConfig config;
  surefoot::Odometry odometry;
  std::mutex mutex;
};

/// Calls without the interpreter's lock, and alone.
template <typename Call>
auto alone(SharedOdometry& self, const Call& call) {
  const py::gil_scoped_release release;
  const std::lock_guard lock(self.mutex);
  return call(self.odometry);
}

std::unique_ptr<SharedOdometry> make_odometry(const py::object& config, int threads,
                                              const std::optional<Matrix4>& T_world_start) {
  if (threads < 1 || threads > 1024) {
    throw std::invalid_argument("threads: got " + std::to_string(threads) + ", expected 1 .. 1024");
  }
  return std::make_unique<SharedOdometry>(config_given(config), threads, T_world_start);
}

py::tuple deskewed(SharedOdometry& self) {
  DeskewedScan scan =
      alone(self, [](const Odometry& odometry) { return odometry.deskewed_scan(); });
  return py::make_tuple(array_of(std::move(scan.points)), array_of(std::move(scan.intensities)));
}

py::tuple emptied(SharedOdometry& self) {
  Cubes cubes = alone(self, [](const Odometry& odometry) { return odometry.emptied_cubes(); });
  return py::make_tuple(cubes.side, array_of(std::move(cubes.centres)));
}

void bind_level(py::module_& module) {
  py::class_<LevelReport>(module, "LevelReport", "How the map's level frame was found.")
      .def_readonly("from_ground", &LevelReport::from_ground)
      .def_readonly("tilt_deg", &LevelReport::tilt_deg, "Between the LiDAR's z axis and the map's.")
      .def_readonly("ground_height", &LevelReport::ground_height,
                    "[m] of the sensor above that ground.")
      .def_readonly("message", &LevelReport::message);
}

}  // namespace

void bind_odometry(py::module_& module) {
  bind_level(module);
  py::class_<SharedOdometry>(module, "Odometry", R"(LiDAR odometry: one scan in, one estimate out.

>>> odometry = Odometry()
>>> for scan in surefoot.open("walk.mcap"):
...     estimate = odometry.add_scan(scan)
...     if estimate.trusted: print(estimate.T_world_lidar)

The same scans give the same bits, at any number of threads, and the same as the program. The
interpreter's lock is released meanwhile.)")
      .def(py::init(&make_odometry), py::arg("config") = py::none(), py::arg("threads") = 1,
           py::arg("T_world_start") = py::none(), R"(
config: a Config, or a method's name; None: method surefoot
threads: at most so many
T_world_start: (4, 4), where the map's frame lies in the caller's world [m]; should not tilt it)")
      .def(
          "add_scan",
          [](SharedOdometry& self, const ArrayScan& scan) {
            const bindings::ScanView view = scan.view();
            return alone(self, [&](Odometry& odometry) {
              return odometry.add_scan(bindings::scan_of(view));
            });
          },
          py::arg("scan"),
          "Never raises for what is in a scan: one that cannot be used is Status.rejected.")
      .def_readonly("config", &SharedOdometry::config, "A copy: it is fixed once made.",
                    py::return_value_policy::copy)
      .def("level",
           [](SharedOdometry& self) {
             return alone(self, [](const Odometry& odometry) { return odometry.level(); });
           })
      .def("deskewed_scan", &deskewed,
           "(points (N, 3) float32 [m], intensities (N,) or (0,)) of the last scan that was not "
           "rejected, at its mid-scan instant, LiDAR frame.")
      .def(
          "local_map",
          [](SharedOdometry& self) {
            return array_of(
                alone(self, [](const Odometry& odometry) { return odometry.local_map(); }));
          },
          "(N, 3) float64 [m], world frame.")
      .def("emptied_cubes", &emptied,
           "(side [m], centres (N, 3) float64 [m]): where the last scan looked through what had "
           "been seen before.");
}

}  // namespace surefoot::python
