// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "scan.hpp"

namespace surefoot::python {

/// A scan of a structured array, read as the program reads the fields of a message.
[[nodiscard]] ArrayScan scan_of_cloud(const py::array& cloud, std::optional<std::int64_t> stamp_ns,
                                      const std::string& time_field, const std::string& time_unit,
                                      const std::string& time_reference,
                                      const std::string& stamp_at);

}  // namespace surefoot::python
