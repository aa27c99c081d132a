// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Simulated recordings, scan by scan or to disk.
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <array>
#include <memory>
#include <mutex>
#include <stdexcept>

#include "arrays.hpp"
#include "bindings.hpp"
#include "poses.hpp"
#include "recordings/recording_maker.hpp"
#include "scan.hpp"
#include "simulation/body_motion.hpp"
#include "simulation/companions.hpp"
#include "simulation/gait.hpp"
#include "words.hpp"

namespace surefoot::python {

namespace {

using recordings::RecordingRequest;

/// A request carried out in memory.
class Simulation {
 public:
  explicit Simulation(RecordingRequest request)
      : request_(std::move(request)),
        lidar_(simulation::lidar_model(request_.lidar)),
        scene_(recordings::scene_of(request_)),
        gait_(recordings::gait_of(request_, scene_)),
        rays_(scene_),
        scanner_(rays_, lidar_, motion(), recordings::scanner_options_of(request_)) {}

  [[nodiscard]] std::uint64_t size() const { return request_.scans; }
  [[nodiscard]] ArrayScan scan(std::uint64_t index) {
    Scan made;
    {
      const py::gil_scoped_release release;
      const std::lock_guard lock(mutex_);
      made = scanner_.scan(index).scan;
    }
    ArrayScan result = array_scan(std::move(made));
    result.name = "scan " + std::to_string(index);
    return result;
  }
  [[nodiscard]] Trajectory truth() const { return true_trajectory(scanner_, request_.scans); }
  [[nodiscard]] const RecordingRequest& request() const { return request_; }

 private:
  simulation::Motion motion() {
    // One turn more than is scanned: the last scan's last firing lies beyond its nominal end.
    const double duration = 1e-9 * lidar_.turn_ns * static_cast<double>(request_.scans + 1);
    simulation::Motion made = simulation::make_motion(scene_, rays_, gait_, duration, request_.seed,
                                                      recordings::mount_of(request_));
    for (const simulation::MovingObject& person : simulation::make_companions(
             request_.people, scene_, rays_, gait_, duration, request_.seed)) {
      rays_.add(person);
    }
    return made;
  }

  RecordingRequest request_;
  simulation::LidarModel lidar_;
  simulation::Scene scene_;
  simulation::GaitModel gait_;
  simulation::RayCaster rays_;
  simulation::Scanner scanner_;
  std::mutex mutex_;
};

std::unique_ptr<Simulation> simulate(const std::string& scene, std::uint64_t scans,
                                     std::uint64_t seed, const std::string& lidar,
                                     const std::string& robot, double speed, double gait_scale,
                                     int people, double rain, double dust, bool footprint) {
  require_within("scans", static_cast<double>(scans), {1, recordings::kMostScans});
  if (speed != 0.0) require_within("speed", speed, recordings::kSpeeds);  // 0: the robot's own
  require_within("gait_scale", gait_scale, recordings::kGaitScales);
  require_within("people", people, {0, recordings::kMostPeople});
  require_within("rain", rain, recordings::kAirShares);
  require_within("dust", dust, recordings::kAirShares);
  RecordingRequest request;
  request.scene = scene;
  request.scans = scans;
  request.seed = seed;
  request.lidar = lidar;
  request.robot = robot;
  request.speed = speed;
  request.gait_scale = gait_scale;
  request.people = people;
  request.air.rain = rain;
  request.air.dust = dust;
  request.footprint = footprint;
  const py::gil_scoped_release release;
  return std::make_unique<Simulation>(std::move(request));
}

std::uint64_t write(const Simulation& self, const std::filesystem::path& folder,
                    const std::vector<std::string>& formats, bool overwrite) {
  RecordingRequest request = self.request();
  request.overwrite = overwrite;
  request.format.pcd = false;
  using Format = recordings::RecordingFormat;
  static constexpr std::array<std::pair<std::string_view, bool Format::*>, 4> kFormats = {
      {{"pcd", &Format::pcd},
       {"pcap", &Format::pcap},
       {"mcap", &Format::mcap},
       {"rosbag2", &Format::rosbag2}}};
  for (const std::string& format : formats) {
    request.format.*choice_of(kFormats, "formats", format) = true;
  }
  bool stopped = false;
  std::uint64_t done = 0;
  {
    const py::gil_scoped_release release;
    done = recordings::make_recording(request, folder, [&](std::uint64_t) {
      const py::gil_scoped_acquire acquire;
      stopped = stopped || PyErr_CheckSignals() != 0;
      return !stopped;
    });
  }
  if (stopped) throw py::error_already_set();
  return done;
}

}  // namespace

void bind_simulation(py::module_& module) {
  py::class_<Simulation>(module, "Simulation",
                         "A robot's walk through a scene: simulation[i] is scan i, made anew "
                         "whenever it is asked for; iterating gives them all.")
      .def("__len__", &Simulation::size)
      .def(
          "__getitem__",
          [](Simulation& self, std::int64_t index) {
            const auto size = static_cast<std::int64_t>(self.size());
            if (index < 0) index += size;
            if (index < 0 || index >= size) throw py::index_error("Simulation: no such scan");
            return self.scan(static_cast<std::uint64_t>(index));
          },
          py::arg("index"))
      .def("__iter__", &iterate_by_index)
      .def_property_readonly(
          "truth", [](const Simulation& self) { return NamedTrajectory{self.truth()}; },
          "The LiDAR's exact poses every 2.5 ms and at every mid-scan.")
      .def(
          "write", &write, py::arg("folder"), py::arg("formats") = std::vector<std::string>{"pcd"},
          py::arg("overwrite") = false,
          "Writes the recording with its truth, as `surefoot simulate -o` does: formats pcd, pcap, "
          "mcap, rosbag2. Returns the number of scans.");
  module.def("simulate", &simulate, py::arg("scene"), py::kw_only(), py::arg("scans") = 600,
             py::arg("seed") = 1, py::arg("lidar") = "vlp16", py::arg("robot") = "",
             py::arg("speed") = 0.0, py::arg("gait_scale") = 1.0, py::arg("people") = 0,
             py::arg("rain") = 0.0, py::arg("dust") = 0.0, py::arg("footprint") = true,
             R"(A simulated recording with exact truth.

scene: one of scenes(), or a file: .ply, .obj, .asc
robot: how it moves, '': what suits the scene; speed [m/s], 0: the robot's own
rain, dust: share of the beams that end in it; footprint: several rays a beam
Same arguments, same bytes; the same as `surefoot simulate`.)");
  module.def(
      "scenes",
      [] {
        py::dict result;
        for (const auto& entry : simulation::scene_catalogue()) {
          result[py::str(entry.name)] = entry.description;
        }
        return result;
      },
      "Scenes that can be simulated, with their descriptions.");
}

}  // namespace surefoot::python
