// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "surefoot/config.hpp"

namespace surefoot::python {

/// A Config that remembers which method's it is.
struct NamedConfig {
  std::string method;
  surefoot::Config config;
};

}  // namespace surefoot::python
