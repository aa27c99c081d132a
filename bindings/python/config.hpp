// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "surefoot/config.hpp"

namespace surefoot::python {

/// A Config that remembers which method's it is.
struct NamedConfig {
  std::string method;
  surefoot::Config config;
};

/// A Config as it is, a method's name, or None: the default method. Throws py::type_error.
[[nodiscard]] NamedConfig config_given(const pybind11::object& config);

}  // namespace surefoot::python
