// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Parameters by name, as values of Python: whatever the tables of the methods hold is here.
#include "config.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>

#include "bindings.hpp"
#include "runs/config_file.hpp"
#include "runs/method_parameters.hpp"
#include "runs/run_options.hpp"

namespace surefoot::python {

namespace {

bool is_whole(const std::string& text) {
  int value = 0;
  const char* const end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  return result.ec == std::errc{} && result.ptr == end;
}

/// A parameter of whole numbers takes no exponent, one of real numbers does.
bool takes_reals(const std::string& name) {
  static const std::set<std::string> names = [] {
    std::set<std::string> found;
    const Config defaults;
    for (const ParameterInfo& info : parameters()) {
      Config config = defaults;
      const std::string text = get_parameter(config, info.name);
      try {
        set_parameter(config, info.name, is_whole(text) ? text + "e0" : text);
        found.insert(info.name);
      } catch (const ConfigError&) {
      }
    }
    return found;
  }();
  return names.count(name) > 0;
}

py::object value_of(const NamedConfig& self, const std::string& name) {
  const std::string text = get_parameter(self.config, name);
  if (text == "true" || text == "false") return py::bool_(text == "true");
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, number);
  if (result.ec != std::errc{} || result.ptr != end) return py::str(text);
  if (takes_reals(name)) return py::float_(number);
  return py::int_(static_cast<long>(number));
}

/// As `--set` takes it.
std::string text_of(const py::handle& value) {
  if (py::isinstance<py::bool_>(value)) return value.cast<bool>() ? "true" : "false";
  return py::str(value);
}

void set(NamedConfig& self, const std::string& name, const py::handle& given) {
  runs::require_parameter(self.config, name);
  py::object value = py::reinterpret_borrow<py::object>(given);
  if (py::hasattr(value, "item")) value = value.attr("item")();  // a number of numpy's
  std::string text = text_of(value);
  // 3.0 for a parameter of whole numbers is 3.
  if (py::isinstance<py::float_>(value) && !takes_reals(name)) {
    const auto number = value.cast<double>();
    constexpr double kMost = std::numeric_limits<int>::max();
    if (std::abs(number) <= kMost && number == std::trunc(number)) {
      text = std::to_string(static_cast<int>(number));
    }
  }
  set_parameter(self.config, name, text);
}

std::vector<std::string> names_of(const NamedConfig& self) {
  std::vector<std::string> names;
  for (const ParameterInfo& info : parameters()) {
    if (reads_parameter(self.config, info.name)) names.push_back(info.name);
  }
  return names;
}

py::list items_of(const NamedConfig& self) {
  py::list items;
  for (const std::string& name : names_of(self)) {
    items.append(py::make_tuple(name, value_of(self, name)));
  }
  return items;
}

/// Of any mapping: a dict, a Config.
void update(NamedConfig& self, const py::object& values) {
  for (const auto& [name, value] : py::dict(values)) set(self, py::str(name), value);
}

NamedConfig make_config(const std::string& method, const py::object& values) {
  NamedConfig result{method, method_config(method)};
  update(result, values);
  return result;
}

NamedConfig load_config(const std::filesystem::path& file) {
  std::string method = runs::method_of_file(file);
  if (method.empty()) method = runs::kDefaultMethod;
  NamedConfig result{method, method_config(method)};
  runs::load_config_file(file, result.config);
  return result;
}

std::string text_of_config(const NamedConfig& self) {
  const Config defaults = method_config(self.method);
  std::string changes;
  for (const std::string& name : names_of(self)) {
    const std::string value = get_parameter(self.config, name);
    if (value == get_parameter(defaults, name)) continue;
    changes += (changes.empty() ? ", {'" : ", '") + name + "': '" + value + "'";
  }
  return "Config('" + self.method + "'" + changes + (changes.empty() ? ")" : "})");
}

bool are_equal(const NamedConfig& a, const NamedConfig& b) {
  if (a.config.method != b.config.method) return false;
  for (const std::string& name : names_of(a)) {
    if (get_parameter(a.config, name) != get_parameter(b.config, name)) return false;
  }
  return true;
}

void bind_parameters(py::module_& module) {
  py::class_<ParameterInfo>(module, "ParameterInfo", "One row of the table of parameters.")
      .def_readonly("name", &ParameterInfo::name)
      .def_readonly("default_value", &ParameterInfo::default_value, "As text.")
      .def_readonly("unit", &ParameterInfo::unit, "Empty where the value has none.")
      .def_readonly("range", &ParameterInfo::range, "As text: '1 .. 64', or the words it takes.")
      .def_readonly("help", &ParameterInfo::help)
      .def_readonly("source", &ParameterInfo::source, "Where the default comes from.")
      .def("__repr__", [](const ParameterInfo& self) {
        return "<ParameterInfo " + self.name + " = " + self.default_value + ": " + self.help + ">";
      });
  module.def("parameters", &parameters, "The table of parameters, whichever method reads them.");
  module.def("methods", &methods, "Names of the methods: named sets of parameters.");
  module.def(
      "method_config", [](const std::string& method) { return make_config(method, py::dict()); },
      py::arg("method"), "Parameters of a method; the same as Config(method).");
}

}  // namespace

NamedConfig config_given(const py::object& config) {
  if (py::isinstance<NamedConfig>(config)) return config.cast<const NamedConfig&>();
  if (!config.is_none() && !py::isinstance<py::str>(config)) {
    throw py::type_error("config: expected a Config, a method's name or None; got a " +
                         py::type::of(config).attr("__name__").cast<std::string>() +
                         "; Config(\"surefoot\", {...}) makes one of parameters");
  }
  return make_config(config.is_none() ? runs::kDefaultMethod : config.cast<std::string>(),
                     py::dict());
}

void bind_config(py::module_& module) {
  py::class_<NamedConfig>(module, "Config", R"(Parameters of a method, by name.

>>> config = Config("surefoot", {"knots.points": 1500})
>>> config["knots.map_voxel"] = 0.2
>>> dict(config)["knots.points"]
1500

Numbers are in SI units unless their name ends otherwise; `surefoot config` prints them all with
unit, range and meaning. A value out of range, an unknown name, or one that the method does not
read, is a ConfigError. Iterating gives the names that the method reads.)")
      .def(py::init(&make_config), py::arg("method") = runs::kDefaultMethod,
           py::arg("values") = py::dict())
      .def_static("load", &load_config, py::arg("file"),
                  "Parameters from a YAML file, or from the run.yaml of a run.")
      .def_readonly("method", &NamedConfig::method, "Name of the method: one of methods().")
      .def("__getitem__", &value_of, py::arg("name"))
      .def("__setitem__", &set, py::arg("name"), py::arg("value"))
      .def(
          "__contains__",
          [](const NamedConfig& self, const std::string& name) {
            return reads_parameter(self.config, name);
          },
          py::arg("name"))
      .def("__len__", [](const NamedConfig& self) { return names_of(self).size(); })
      .def("__iter__", [](const NamedConfig& self) { return py::iter(py::cast(names_of(self))); })
      .def("keys", &names_of)
      .def("items", &items_of)
      .def("update", &update, py::arg("values"), "Sets several parameters, of any mapping.")
      .def(
          "validate", [](const NamedConfig& self) { validate(self.config); },
          "Raises ConfigError where two values contradict each other; Odometry does so, too.")
      .def("__copy__", [](const NamedConfig& self) { return self; })
      .def(
          "__deepcopy__", [](const NamedConfig& self, const py::dict&) { return self; },
          py::arg("memo"))
      .def("__eq__", &are_equal, py::is_operator())
      .def("__repr__", &text_of_config)
      .def(py::pickle(
          [](const NamedConfig& self) { return py::make_tuple(self.method, items_of(self)); },
          [](const py::tuple& state) {
            return make_config(state[0].cast<std::string>(), state[1]);
          }));
  bind_parameters(module);
}

}  // namespace surefoot::python
