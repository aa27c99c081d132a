// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "surefoot/estimate.hpp"

#include <pybind11/stl.h>

#include <map>
#include <string>
#include <vector>

#include "bindings.hpp"
#include "poses.hpp"

namespace surefoot::python {

namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;

std::map<std::string, double> evidence_of(const Evidence& evidence) {
  std::map<std::string, double> values;
  for (const EvidenceField& field : kEvidenceFields) values[field.name] = evidence.*field.member;
  return values;
}

void bind_parts(py::module_& module) {
  py::enum_<Status>(module, "Status", "Whether a pose can be trusted.")
      .value("ok", Status::ok, "Registered, every direction observed.")
      .value("first_scan", Status::first_scan, "The map begins (again) with this scan.")
      .value("degenerate", Status::degenerate,
             "Registered, but the directions named in `degenerate` rest on little.")
      .value("too_few_matches", Status::too_few_matches,
             "Not registered: the pose is the prediction, the map is unchanged.")
      .value("diverged", Status::diverged, "Registration ended somewhere implausible: likewise.")
      .value("lost", Status::lost,
             "It does not know where it is and searches: the pose is a guess, likewise.")
      .value("rejected", Status::rejected,
             "The scan could not be used, `message` says why; nothing changed.");
  py::class_<StageReport>(module, "StageReport", "What one stage of the registration did.")
      .def_property_readonly(
          "name", [](const StageReport& self) { return std::string(self.name); },
          "'registration' where a method has no other.")
      .def_readonly("iterations", &StageReport::iterations)
      .def_readonly("matches", &StageReport::matches, "Correspondences in the last iteration.")
      .def_readonly("residual", &StageReport::residual, "[m] weighted RMS over these.")
      .def_readonly("observability", &StageReport::observability,
                    "Method paper's vertical stage: mean of Omega_i, eq. (30).");
  py::class_<DegenerateDirection>(module, "DegenerateDirection",
                                  "A motion that the scan hardly constrains.")
      .def_readonly("direction", &DegenerateDirection::direction,
                    "(6,) unit vector x y z roll pitch yaw in the world's axes about the sensor.")
      .def_readonly("information", &DegenerateDirection::information,
                    "Its share of what an evenly built scene would give (1).")
      .def_readonly("name", &DegenerateDirection::name,
                    "Its largest part: forward, lateral, up, roll, pitch or yaw.");
}

}  // namespace

void bind_estimate(py::module_& module) {
  bind_parts(module);
  py::class_<Estimate>(module, "Estimate", "The answer to one scan.")
      .def_readonly("status", &Estimate::status)
      .def_readonly("segment", &Estimate::segment,
                    "Poses of one segment are in one frame; how segments lie to each other is not "
                    "known.")
      .def_readonly("message", &Estimate::message, "What was seen and expected; empty when ok.")
      .def_readonly("stamp_ns", &Estimate::stamp_ns, "[ns] mid-scan, the instant of the pose.")
      .def_property_readonly(
          "T_world_lidar", [](const Estimate& self) { return matrix_of(self.T_world_lidar); },
          "(4, 4) float64 [m]: pose at mid-scan.")
      .def_property_readonly(
          "twist", [](const Estimate& self) { return self.twist; },
          "(6,) mean velocity of the last motion, LiDAR frame [m/s, rad/s].")
      .def_property_readonly(
          "covariance", [](const Estimate& self) { return Matrix6(self.covariance); },
          "(6, 6) of the pose: x y z roll pitch yaw in the world's axes about the sensor [m, rad].")
      .def_readonly("degenerate", &Estimate::degenerate, "Weak directions, the weakest first.")
      .def_property_readonly(
          "evidence", [](const Estimate& self) { return evidence_of(self.evidence); },
          "What speaks against the pose, by name: docs/method.md, \"Is it right?\".")
      .def_readonly("wrong_probability", &Estimate::wrong_probability,
                    "That the pose is wrong by more than 0.2 m or 3 degrees against that of ten "
                    "scans before; NaN where that is not told.")
      .def_readonly("converged", &Estimate::converged)
      .def_property_readonly(
          "stages",
          [](const Estimate& self) {
            return std::vector<StageReport>(self.stages.begin(), self.stages.end());
          },
          "StageReports in their order; none of a scan that was not registered.")
      .def_readonly("points", &Estimate::points, "Valid points of the scan.")
      .def_readonly("registered_points", &Estimate::registered_points, "Of these, registered.")
      .def_property_readonly(
          "start_ns", [](const Estimate& self) { return self.trajectory.start_ns(); },
          "[ns] first instant of the scan.")
      .def_property_readonly(
          "end_ns", [](const Estimate& self) { return self.trajectory.end_ns(); },
          "[ns] last instant of the scan.")
      .def(
          "pose_at",
          [](const Estimate& self, std::int64_t instant_ns) {
            return matrix_of(self.pose_at(instant_ns));
          },
          py::arg("instant_ns"), "(4, 4) pose at any instant of the scan [ns, sensor's epoch].")
      .def_property_readonly("trusted", &Estimate::trusted,
                             "Whether the pose was measured: ok, first_scan or degenerate.")
      .def("__repr__", [](const Estimate& self) {
        const Eigen::Vector3d& t = self.T_world_lidar.translation;
        return "<Estimate " + std::string(to_string(self.status)) + " at " +
               std::to_string(self.stamp_ns) + " ns: " + std::to_string(t.x()) + " " +
               std::to_string(t.y()) + " " + std::to_string(t.z()) + " m>";
      });
}

}  // namespace surefoot::python
