// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <mutex>
#include <optional>
#include <utility>

#include "arrays.hpp"
#include "bindings.hpp"
#include "io/file_writer.hpp"
#include "io/recording.hpp"
#include "poses.hpp"
#include "surefoot/localizer.hpp"
#include "surefoot/mapper.hpp"

namespace surefoot::python {

namespace {

using Points = py::array_t<float, py::array::c_style | py::array::forcecast>;

/// A Mapper or a Localizer that threads of Python may share: one at a time has it.
template <typename Kind>
struct Shared {
  template <typename... Arguments>
  explicit Shared(Arguments&&... arguments) : kind(std::forward<Arguments>(arguments)...) {}

  Kind kind;
  std::mutex mutex;
};

/// Calls without the interpreter's lock, and alone.
template <typename Kind, typename Call>
auto alone(Shared<Kind>& self, const Call& call) {
  const py::gil_scoped_release release;
  const std::lock_guard lock(self.mutex);
  return call(self.kind);
}

/// What the C++ library says of a file, as this module's exception. What was called too early or
/// too late is not of a file.
template <typename Error, typename Call>
auto with_error(const Call& call) {
  try {
    return call();
  } catch (const std::runtime_error& error) {
    throw Error(error.what());
  }
}

template <typename Kind>
void add(Shared<Kind>& self, const Estimate& estimate, const Points& points) {
  if (points.ndim() != 2 || points.shape(1) != 3) {
    throw std::invalid_argument("points: got " + shape_of(points) + ", expected (N, 3) float32");
  }
  DeskewedScan scan;
  const auto* const data = reinterpret_cast<const Eigen::Vector3f*>(points.data());
  scan.points.assign(data, data + points.shape(0));
  alone(self, [&](Kind& kind) { kind.add(estimate, scan); });
}

constexpr const char* kAdd = R"(
estimate: of Odometry.add_scan
points: (N, 3) float32 [m], LiDAR frame at estimate.stamp_ns: Odometry.deskewed_scan()[0]

In the order in which they came. One that is not trusted is passed over.)";

std::optional<Matrix4> matrix_of(const std::optional<Pose>& pose) {
  return pose ? std::optional(python::matrix_of(*pose)) : std::nullopt;
}

void bind_mapper(py::module_& module) {
  using Self = Shared<Mapper>;
  py::class_<JoinReport>(module, "JoinReport", "What came of a map that was to be continued.")
      .def_readonly("joined", &JoinReport::joined)
      .def_readonly("compared", &JoinReport::compared, "Places.")
      .def_readonly("loops", &JoinReport::loops, "Between the two maps, that were taken.")
      .def_readonly("message", &JoinReport::message, "Why it was not joined; else empty.");
  py::class_<Self>(module, "Mapper", R"(A map of a walk, with the places visited again put together.

>>> odometry, mapper = Odometry(), Mapper()
>>> for scan in surefoot.open("walk.mcap"):
...     estimate = odometry.add_scan(scan)
...     mapper.add(estimate, odometry.deskewed_scan()[0])
>>> mapper.finish()
>>> mapper.save("map.surefoot")

The odometry is left alone. The same calls give the same bits; the interpreter's lock is released
meanwhile. Before finish() all but add() raises RuntimeError, after it add() does.)")
      .def(py::init<>())
      .def("add", &add<Mapper>, py::arg("estimate"), py::arg("points"), kAdd)
      .def(
          "finish", [](Self& self) { alone(self, [](Mapper& mapper) { mapper.finish(); }); },
          "Ends the walk, chooses among the loops and moves the poses. Once.")
      .def(
          "join",
          [](Self& self, const std::filesystem::path& map) {
            return with_error<io::ReadError>(
                [&] { return alone(self, [&](Mapper& mapper) { return mapper.join(map); }); });
          },
          py::arg("map"),
          "Joins it to a saved map (file, or the folder with its map.surefoot): then all that "
          "follows is in that one's frame, and save() writes both as one. Else nothing changes. "
          "Raises ReadError; RuntimeError where it is joined to one already.")
      .def(
          "trajectory",
          [](Self& self) {
            return NamedTrajectory{
                alone(self, [](const Mapper& mapper) { return mapper.trajectory(); })};
          },
          "T_map_lidar of every trusted estimate, after all loops. Without stretches that nothing "
          "holds to a map that it was joined to.")
      .def(
          "T_map_world",
          [](Self& self, std::int64_t stamp_ns) {
            return matrix_of(
                alone(self, [&](const Mapper& mapper) { return mapper.T_map_world(stamp_ns); }));
          },
          py::arg("stamp_ns"),
          "(4, 4), from the odometry's world to the map, at an instant; None in stretches that "
          "nothing holds to a map that it was joined to.")
      .def_property_readonly(
          "loops",
          [](Self& self) { return alone(self, [](const Mapper& m) { return m.loops(); }); },
          "How many were taken within the walk.")
      .def_property_readonly(
          "compared",
          [](Self& self) { return alone(self, [](const Mapper& m) { return m.compared(); }); },
          "How many places were compared for that.")
      .def(
          "save",
          [](Self& self, const std::filesystem::path& file) {
            with_error<io::WriteError>(
                [&] { alone(self, [&](const Mapper& mapper) { mapper.save(file); }); });
          },
          py::arg("file"), "The old file or the whole new one is there. Raises WriteError.");
}

void bind_localizer(py::module_& module) {
  using Self = Shared<Localizer>;
  py::class_<Self>(module, "Localizer", R"(Where in a saved map the robot is, from an unknown start.

>>> odometry, localizer = Odometry(), Localizer("map.surefoot")
>>> for scan in surefoot.open("again.mcap"):
...     localizer.add(odometry.add_scan(scan), odometry.deskewed_scan()[0])
...     print(localizer.T_map_lidar, localizer.message)

"Not found yet" is an answer; a wrong place is none. The interpreter's lock is released meanwhile.)")
      .def(py::init([](const std::filesystem::path& map) {
             return with_error<io::ReadError>([&] {
               const py::gil_scoped_release release;
               return std::make_unique<Self>(map);
             });
           }),
           py::arg("map"),
           "What Mapper.save() or `surefoot map` has written, or the folder with its map.surefoot. "
           "Raises ReadError.")
      .def("add", &add<Localizer>, py::arg("estimate"), py::arg("points"), kAdd)
      .def_property_readonly(
          "T_map_lidar",
          [](Self& self) {
            return matrix_of(alone(self, [](const Localizer& l) { return l.T_map_lidar(); }));
          },
          "(4, 4) of the last scan; None: not found yet, lost, or its estimate was not trusted.")
      .def_property_readonly(
          "T_map_world",
          [](Self& self) {
            return matrix_of(alone(self, [](const Localizer& l) { return l.T_map_world(); }));
          },
          "(4, 4), from the odometry's world to the map; None: not found yet, or lost.")
      .def_property_readonly(
          "message",
          [](Self& self) {
            return alone(self, [](const Localizer& l) { return std::string(l.message()); });
          },
          "One sentence about the last search or check.");
}

}  // namespace

void bind_mapping(py::module_& module) {
  bind_mapper(module);
  bind_localizer(module);
}

}  // namespace surefoot::python
