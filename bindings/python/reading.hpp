// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// How a recording is to be read: the program's options, with _ for -, as keyword arguments.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bindings.hpp"
#include "io/recording.hpp"

namespace surefoot::python {

[[nodiscard]] io::TimeUnit time_unit_named(const std::string& name);
[[nodiscard]] io::TimeReference time_reference_named(const std::string& name);
[[nodiscard]] io::StampAt stamp_at_named(const std::string& name);

/// Sets the option of that name, unless its value is None: not given. False where there is none.
[[nodiscard]] bool set_reading_option(io::OpenOptions& options, const std::string& name,
                                      const py::handle& value);
/// Refuses a keyword that a function does not have, naming its own, then those of reading.
[[noreturn]] void refuse_keyword(const std::string& function, const std::string& name,
                                 const std::vector<std::string>& own);
/// Names of the options of reading.
[[nodiscard]] std::vector<std::string> reading_option_names();

}  // namespace surefoot::python
