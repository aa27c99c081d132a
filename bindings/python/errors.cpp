// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What is thrown arrives as an exception with the same text.
#include "bindings.hpp"
#include "io/file_writer.hpp"
#include "io/recording.hpp"
#include "surefoot/config.hpp"

namespace surefoot::python {

void bind_errors(py::module_& module) {
  py::register_exception<ConfigError>(module, "ConfigError", PyExc_ValueError).doc() =
      "A parameter's value out of range, or an unknown name; says what was expected.";
  py::register_exception<io::ReadError>(module, "ReadError", PyExc_RuntimeError).doc() =
      "A recording is not what it should be; says which file, what was seen and expected.";
  py::register_exception<io::WriteError>(module, "WriteError", PyExc_RuntimeError).doc() =
      "A file cannot be written.";
}

}  // namespace surefoot::python
