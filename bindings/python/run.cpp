// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// `surefoot run` from Python, and what it left.
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <optional>

#include "arrays.hpp"
#include "bindings.hpp"
#include "config.hpp"
#include "poses.hpp"
#include "process/build_version.hpp"
#include "reading.hpp"
#include "runs/odometry_run.hpp"
#include "runs/run_folder.hpp"

namespace surefoot::python {

namespace {

using runs::RunOptions;

struct RunKeyword {
  const char* name;
  void (*set)(RunOptions& options, const py::handle& value);
};

const RunKeyword kRunKeywords[] = {
    {"extrinsic",
     [](auto& o, const auto& v) { o.extrinsic = v.template cast<std::vector<double>>(); }},
    {"level", [](auto& o, const auto& v) { o.level = py::str(v); }},
    {"threads", [](auto& o, const auto& v) { o.threads = v.template cast<int>(); }},
    {"start", [](auto& o, const auto& v) { o.start = v.template cast<std::size_t>(); }},
    {"count", [](auto& o, const auto& v) { o.count = v.template cast<std::size_t>(); }},
    {"stride", [](auto& o, const auto& v) { o.stride = v.template cast<std::size_t>(); }},
    {"overwrite", [](auto& o, const auto& v) { o.overwrite = v.template cast<bool>(); }},
    {"mcap", [](auto& o, const auto& v) { o.mcap = v.template cast<std::filesystem::path>(); }},
    {"rosbag2",
     [](auto& o, const auto& v) { o.rosbag2 = v.template cast<std::filesystem::path>(); }},
    {"truth", [](auto& o, const auto& v) { o.truth = v.template cast<std::filesystem::path>(); }},
    {"pose_of", [](auto& o, const auto& v) { o.pose_of = py::str(v); }},
    {"map_voxel", [](auto& o, const auto& v) { o.map_voxel = v.template cast<double>(); }},
    {"pose_rate", [](auto& o, const auto& v) { o.pose_rate = v.template cast<double>(); }},
    {"loop_closure", [](auto& o, const auto& v) { o.loop_closure = v.template cast<bool>(); }},
    {"localize",
     [](auto& o, const auto& v) { o.localize = v.template cast<std::filesystem::path>(); }},
    {"map", [](auto& o, const auto& v) { o.continued = v.template cast<std::filesystem::path>(); }},
    {"no_map", [](auto& o, const auto& v) { o.no_map = v.template cast<bool>(); }},
    {"no_picture", [](auto& o, const auto& v) { o.no_picture = v.template cast<bool>(); }},
    {"no_report", [](auto& o, const auto& v) { o.no_report = v.template cast<bool>(); }},
};

/// Not repeated by a run.yaml: recorded as parameters, or nothing to do with the results.
bool is_recorded(const std::string& name) {
  for (const char* other :
       {"extrinsic", "level", "threads", "overwrite", "mcap", "rosbag2", "truth"}) {
    if (name == other) return false;
  }
  return true;
}

/// As the command line has it: dashes, and what Python calls `returns` is --return.
void record(RunOptions& options, std::string name, const py::handle& value) {
  if (name == "returns") name = "return";
  for (char& c : name) c = c == '_' ? '-' : c;
  std::string text = py::str(value);
  if (py::isinstance<py::bool_>(value)) text = value.cast<bool>() ? "true" : "false";
  for (const char* file : {"stamps", "calibration", "localize", "map"}) {
    if (name == file) text = std::filesystem::absolute(text).string();
  }
  options.given.emplace_back(name, text);
}

bool set_option(RunOptions& options, const std::string& name, const py::handle& value) {
  if (set_reading_option(options.reader, name, value)) return true;
  for (const RunKeyword& option : kRunKeywords) {
    if (name != option.name) continue;
    if (value.is_none()) return true;
    try {
      option.set(options, value);
    } catch (const py::cast_error&) {
      throw py::type_error(name + ": got " + std::string(py::repr(value)));
    }
    return true;
  }
  return false;
}

std::vector<std::string> run_option_names() {
  std::vector<std::string> names = {"config", "say", "progress"};
  for (const RunKeyword& option : kRunKeywords) names.emplace_back(option.name);
  return names;
}

void check(const RunOptions& options) {
  const auto refuse = [](const char* what) { throw std::invalid_argument(what); };
  if (options.threads < 1 || options.threads > 1024) refuse("threads: expected 1 .. 1024");
  if (options.count < 1 || options.stride < 1) refuse("count, stride: expected at least 1");
  if (!(options.map_voxel >= 0.01 && options.map_voxel <= 10.0)) {
    refuse("map_voxel: expected 0.01 .. 10 m");
  }
  if (!(options.pose_rate == 0.0 || (options.pose_rate >= 0.1 && options.pose_rate <= 1e5))) {
    refuse("pose_rate: expected 0.1 .. 100000 Hz");
  }
  if (options.pose_of != "lidar" && options.pose_of != "base") {
    refuse("pose_of: expected lidar or base");
  }
  if (!options.extrinsic.empty() && options.extrinsic.size() != 6) {
    refuse("extrinsic: expected x y z [m] roll pitch yaw [deg]");
  }
}

void set_config(RunOptions& options, const py::object& config) {
  if (config.is_none()) return;
  const NamedConfig named = config_given(config);
  options.method = named.method;
  const Config defaults = method_config(named.method);
  for (const ParameterInfo& info : parameters()) {
    const std::string value = get_parameter(named.config, info.name);
    if (value != get_parameter(defaults, info.name)) {
      options.settings.push_back(info.name + "=" + value);
    }
  }
}

/// Runs it in good order to its end, also where Python has raised something meanwhile (Ctrl-C, or
/// what is told of it): then it ends after the scan, and that is raised when all is written.
std::filesystem::path run_to_folder(const RunOptions& options, const py::object& say,
                                    const py::object& progress) {
  std::optional<py::error_already_set> raised;
  const auto tell = [&](const py::object& who, const auto&... what) {
    const py::gil_scoped_acquire acquire;
    if (who.is_none() || raised) return;
    try {
      who(what...);
    } catch (const py::error_already_set& error) {
      raised = error;
    }
  };
  const auto is_stopped = [&] {
    const py::gil_scoped_acquire acquire;
    if (!raised && PyErr_CheckSignals() != 0) raised.emplace();
    return raised.has_value();
  };
  const runs::RunListener listener{
      [&](const std::string& text) { tell(say, text); },
      [&](std::size_t scans, double share) { tell(progress, scans, share); }, is_stopped};
  runs::RunOutcome outcome;
  try {
    const py::gil_scoped_release release;
    outcome = runs::run_odometry(options, listener);
  } catch (const std::exception&) {
    if (!raised) throw;
  }
  if (raised) throw py::error_already_set(*raised);
  return outcome.folder;
}

std::filesystem::path run(const std::filesystem::path& input,
                          const std::optional<std::filesystem::path>& output,
                          const py::object& config, const py::object& say,
                          const py::object& progress, const py::kwargs& keywords) {
  RunOptions options;
  options.version = process::build_version();
  options.input = input;
  options.output = output.value_or("");
  set_config(options, config);
  for (const auto& [key, value] : keywords) {
    const std::string name = py::str(key);
    if (!set_option(options, name, value)) refuse_keyword("run", name, run_option_names());
    if (is_recorded(name) && !value.is_none()) record(options, name, value);
  }
  check(options);
  return run_to_folder(options, say, progress);
}

py::dict table_of(const report::ScanTable& scans) {
  py::dict table;
  table["stamp_ns"] = array_of(scans.stamps_ns);
  table["status"] = scans.statuses;
  table["message"] = scans.messages;
  table["degenerate"] = scans.degenerate;
  for (const report::ScanColumn& column : scans.columns) {
    table[py::str(column.name)] = array_of(column.values);
  }
  return table;
}

py::dict parameters_of(const runs::RunFolder& self) {
  py::dict result;
  for (const report::ReportParameter& one : self.parameters) {
    result[py::str(one.name)] = one.value;
  }
  return result;
}

}  // namespace

void bind_run(py::module_& module) {
  py::class_<runs::RunFolder>(module, "RunFolder", "What a run left, read back from its folder.")
      .def_readonly("input", &runs::RunFolder::input, "The recording.")
      .def_readonly("method", &runs::RunFolder::method)
      .def_readonly("notes", &runs::RunFolder::notes)
      .def_property_readonly("facts",
                             [](const runs::RunFolder& self) {
                               py::dict facts;
                               for (const auto& [name, text] : self.facts) {
                                 facts[py::str(name)] = text;
                               }
                               return facts;
                             })
      .def_property_readonly("parameters", &parameters_of, "By name, as text.")
      .def_property_readonly(
          "scans", [](const runs::RunFolder& self) { return table_of(self.scans); },
          "A column of scans.csv each: pandas.DataFrame(run.scans).")
      .def_property_readonly(
          "trajectory", [](const runs::RunFolder& self) { return NamedTrajectory{self.measured}; },
          "The measured poses: T_world_lidar (or base).")
      .def_property_readonly(
          "map_points", [](const runs::RunFolder& self) { return array_of(self.map.points); },
          "(N, 3) float32 [m], map frame.")
      .def_property_readonly("map_intensities", [](const runs::RunFolder& self) {
        return array_of(self.map.intensities);
      });
  module.def("read_run_folder", &runs::read_run_folder, py::arg("folder"),
             py::call_guard<py::gil_scoped_release>());
  module.def("run_to_folder", &run, py::arg("input"), py::arg("output") = py::none(), py::kw_only(),
             py::arg("config") = py::none(), py::arg("say") = py::none(),
             py::arg("progress") = py::none());
}

}  // namespace surefoot::python
