// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Public data sets by name, and true trajectories as they give them.
#include "io/datasets.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>

#include "bindings.hpp"
#include "io/truth_files.hpp"
#include "poses.hpp"
#include "runs/trajectory_inputs.hpp"

namespace surefoot::python {

namespace {

py::object matrix_or_none(const std::optional<Pose>& pose) {
  return pose ? py::cast(matrix_of(*pose)) : py::none();
}

io::Truth read_truth(const std::filesystem::path& path, const std::string& dataset,
                     const std::string& topic) {
  const io::Dataset* const set = dataset.empty() ? nullptr : &io::dataset_named(dataset);
  const bool of_records = set != nullptr && set->truth == io::TruthOf::oxts;  // a folder of them
  const py::gil_scoped_release release;
  return io::read_truth(of_records ? path : runs::trajectory_file(path), set, topic);
}

}  // namespace

void bind_datasets(py::module_& module) {
  using io::Dataset;
  py::class_<Dataset>(module, "DatasetInfo",
                      "What `open(..., dataset=name)` knows of a public data set.")
      .def_readonly("name", &Dataset::name)
      .def_readonly("what", &Dataset::what, "Robot and LiDAR.")
      .def_readonly("topics", &Dataset::topics, "Of a bag, the first that it has is taken.")
      .def_property_readonly(
          "T_base_lidar", [](const Dataset& set) { return matrix_or_none(set.T_base_lidar); },
          "4x4 [m]; None where it is not known.")
      .def_property_readonly(
          "T_lidar_truth", [](const Dataset& set) { return matrix_or_none(set.T_lidar_truth); },
          "4x4 [m], of the frame or point that the truth tells; None: the LiDAR itself.")
      .def_readonly("truth_file", &Dataset::truth_file, "As it is usually called.")
      .def_readonly("remark", &Dataset::remark)
      .def_readonly("tried", &Dataset::tried, "What was tried, and on what.")
      .def("__repr__", [](const Dataset& set) { return "<DatasetInfo " + set.name + ">"; });
  module.def(
      "datasets", [] { return io::datasets(); }, "The public data sets that are known by name.");
  py::class_<io::Truth>(module, "Truth", "A true trajectory, as a data set gives it.")
      .def_property_readonly("trajectory",
                             [](const io::Truth& truth) { return NamedTrajectory{truth.poses}; })
      .def_readonly("has_stamps", &io::Truth::has_stamps, "Else they are numbers from 0 on.")
      .def_readonly("has_rotations", &io::Truth::has_rotations,
                    "Else they are the identity and mean nothing.")
      .def_property_readonly(
          "T_lidar_truth", [](const io::Truth& truth) { return matrix_of(truth.T_lidar_truth); },
          "4x4 [m], of the frame or point that it tells.")
      .def_readonly("what", &io::Truth::what)
      .def("__len__", [](const io::Truth& truth) { return truth.poses.size(); });
  module.def("read_truth", &read_truth, py::arg("path"), py::arg("dataset") = "",
             py::arg("topic") = "",
             "Reads a true trajectory: a table of 4 to 17 columns, a recording's folder with its "
             "gt.tum, or a bag's topic, as `surefoot eval` does. dataset: one of datasets(); "
             "topic: of a bag.");
}

}  // namespace surefoot::python
