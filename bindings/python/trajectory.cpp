// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <stdexcept>

#include "arrays.hpp"
#include "bindings.hpp"
#include "io/trajectory_files.hpp"
#include "numbers.hpp"
#include "poses.hpp"
#include "surefoot/estimate.hpp"

namespace surefoot::python {

namespace {

using Stamps = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;
using Matrices = py::array_t<double, py::array::c_style | py::array::forcecast>;

NamedTrajectory make_trajectory(const py::object& given_stamps, const py::object& given_poses) {
  const Stamps stamps_ns = numbers_of<std::int64_t>(given_stamps, "stamps_ns");
  const Matrices poses = numbers_of<double>(given_poses, "poses");
  if (stamps_ns.ndim() != 1 || poses.ndim() != 3 || poses.shape(1) != 4 || poses.shape(2) != 4 ||
      poses.shape(0) != stamps_ns.shape(0)) {
    throw std::invalid_argument("Trajectory: got stamps_ns " + shape_of(stamps_ns) + " and poses " +
                                shape_of(poses) + ", expected (N,) and (N, 4, 4)");
  }
  NamedTrajectory result;
  for (py::ssize_t i = 0; i < stamps_ns.shape(0); ++i) {
    result.poses.push_back(
        {stamps_ns.at(i), pose_of(Eigen::Map<const Matrix4>(poses.data(i, 0, 0)))});
  }
  return result;
}

py::array_t<std::int64_t> stamps_of(const NamedTrajectory& self) {
  std::vector<std::int64_t> stamps;
  stamps.reserve(self.poses.size());
  for (const StampedPose& pose : self.poses) stamps.push_back(pose.stamp_ns);
  return array_of(std::move(stamps));
}

py::array_t<double> matrices_of(const NamedTrajectory& self) {
  const auto size = static_cast<py::ssize_t>(self.poses.size());
  py::array_t<double> result({size, py::ssize_t{4}, py::ssize_t{4}});
  for (py::ssize_t i = 0; i < size; ++i) {
    Eigen::Map<Matrix4>(result.mutable_data(i, 0, 0)) =
        matrix_of(self.poses[static_cast<std::size_t>(i)].pose);
  }
  return result;
}

py::array_t<double> positions_of(const NamedTrajectory& self) {
  std::vector<Eigen::Vector3d> positions;
  positions.reserve(self.poses.size());
  for (const StampedPose& pose : self.poses) positions.push_back(pose.pose.translation);
  return array_of(std::move(positions));
}

py::array_t<double> quaternions_of(const NamedTrajectory& self) {
  const auto size = static_cast<py::ssize_t>(self.poses.size());
  py::array_t<double> result({size, py::ssize_t{4}});
  for (py::ssize_t i = 0; i < size; ++i) {
    Eigen::Map<Eigen::Vector4d>(result.mutable_data(i, 0)) =
        self.poses[static_cast<std::size_t>(i)].pose.rotation.coeffs();
  }
  return result;
}

py::tuple element(const NamedTrajectory& self, py::ssize_t i) {
  const auto size = static_cast<py::ssize_t>(self.poses.size());
  if (i < 0) i += size;
  if (i < 0 || i >= size) throw py::index_error("Trajectory: index out of range");
  const StampedPose& pose = self.poses[static_cast<std::size_t>(i)];
  return py::make_tuple(pose.stamp_ns, matrix_of(pose.pose));
}

}  // namespace

Pose pose_of(const Matrix4& matrix) {
  const Eigen::Matrix3d R = matrix.topLeftCorner<3, 3>();
  constexpr double kSlack = 1e-6;
  const bool rigid =
      matrix.allFinite() && (R * R.transpose() - Eigen::Matrix3d::Identity()).norm() < kSlack &&
      R.determinant() > 0.0 && (matrix.row(3) - Eigen::RowVector4d(0, 0, 0, 1)).norm() < kSlack;
  if (!rigid) {
    throw std::invalid_argument(
        "got a 4x4 matrix that is no rigid motion, expected a rotation, a translation and the last "
        "row 0 0 0 1");
  }
  return {Eigen::Quaterniond(R).normalized(), matrix.topRightCorner<3, 1>()};
}

void bind_trajectory(py::module_& module) {
  py::class_<NamedTrajectory>(module, "Trajectory",
                              "Poses in the order of their stamps; iterating gives (stamp_ns, T).")
      .def(py::init<>())
      .def(py::init(&make_trajectory), py::arg("stamps_ns"), py::arg("poses"),
           "stamps_ns: (N,) int64 [ns]; poses: (N, 4, 4) T_world_body [m].")
      .def(
          "append",
          [](NamedTrajectory& self, std::int64_t stamp_ns, const Matrix4& pose) {
            self.poses.push_back({stamp_ns, pose_of(pose)});
          },
          py::arg("stamp_ns"), py::arg("pose"), "Adds a pose: 4x4 T_world_body [m].")
      .def(
          "add",
          [](NamedTrajectory& self, const Estimate& estimate) {
            self.poses.push_back({estimate.stamp_ns, estimate.T_world_lidar});
          },
          py::arg("estimate"), "Adds an estimate's pose, bit for bit.")
      .def_property_readonly("stamps_ns", &stamps_of, "(N,) int64 [ns].")
      .def_property_readonly("poses", &matrices_of, "(N, 4, 4) float64, T_world_body [m].")
      .def_property_readonly("positions", &positions_of, "(N, 3) float64 [m].")
      .def_property_readonly("quaternions", &quaternions_of, "(N, 4) float64, x y z w.")
      .def("__len__", [](const NamedTrajectory& self) { return self.poses.size(); })
      .def("__getitem__", &element, py::arg("index"))
      .def("__iter__", &iterate_by_index)
      .def("__repr__", [](const NamedTrajectory& self) {
        return "<Trajectory of " + std::to_string(self.poses.size()) + " poses>";
      });
  module.def(
      "read_tum",
      [](const std::filesystem::path& file) { return NamedTrajectory{io::read_tum(file)}; },
      py::arg("file"), "Reads 't x y z qx qy qz qw' lines, t in seconds.");
  module.def(
      "write_tum",
      [](const std::filesystem::path& file, const NamedTrajectory& trajectory) {
        io::write_tum(file, trajectory.poses);
      },
      py::arg("file"), py::arg("trajectory"),
      "Writes 't x y z qx qy qz qw' lines, as `surefoot run` does.");
}

}  // namespace surefoot::python
