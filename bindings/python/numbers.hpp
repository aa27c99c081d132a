// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Numbers that callers give, as arrays of the type that is wanted. What would change its value
// unsaid is refused: dates, fractions where whole numbers are wanted, what does not fit.
#pragma once

#include <pybind11/numpy.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

#include "arrays.hpp"
#include "bindings.hpp"

namespace surefoot::python {

/// An array of integers, reals or booleans, also from Python's own numbers in an array of objects.
inline py::array plain_numbers(const py::object& given, const char* what) {
  const auto is_plain = [](const py::array& array) {
    return array && std::string_view("biuf").find(array.dtype().kind()) != std::string_view::npos;
  };
  py::array array = py::array::ensure(given);
  if (array && array.dtype().kind() == 'O') array = py::array::ensure(array.attr("tolist")());
  if (is_plain(array)) return array;
  const bool is_shown = !array || array.ndim() == 0;
  throw std::invalid_argument(
      std::string(what) + ": got " +
      (is_shown ? std::string(py::repr(given)) : "an array " + shape_of(array)) +
      ", expected numbers");
}

/// A conversion to fewer bits would wrap silently: stamps for times, -1 for no ring.
template <typename Number>
void require_in_range(const py::array& array, const char* what) {
  if (array.size() == 0) return;
  const py::object least = array.attr("min")().attr("item")();
  const py::object most = array.attr("max")().attr("item")();
  const py::int_ low(std::numeric_limits<Number>::min()), high(std::numeric_limits<Number>::max());
  if (least >= low && most <= high) return;  // not so of NaN
  const auto range = [](const py::object& from, const py::object& to) {
    return std::string(py::str(from)) + " to " + std::string(py::str(to));
  };
  throw std::invalid_argument(std::string(what) + ": got " + range(least, most) + ", expected " +
                              range(low, high));
}

/// Seconds for nanoseconds would all be zero.
inline void require_whole(const py::array& array, const char* what) {
  if (array.dtype().kind() != 'f') return;
  const py::array_t<double, py::array::c_style | py::array::forcecast> values(array);
  for (py::ssize_t i = 0; i < values.size(); ++i) {
    const double value = values.data()[i];
    if (value == std::trunc(value)) continue;
    throw std::invalid_argument(std::string(what) + ": got " +
                                std::string(py::repr(py::float_(value))) +
                                ", expected whole numbers");
  }
}

/// An array of this type: as it lies, or converted.
template <typename Number>
py::array numbers_of(const py::object& given, const char* what) {
  if (py::isinstance<py::array_t<Number>>(given)) return py::reinterpret_borrow<py::array>(given);
  const py::array array = plain_numbers(given, what);
  if constexpr (std::is_integral_v<Number>) {
    require_in_range<Number>(array, what);
    require_whole(array, what);
  }
  return py::array_t<Number, py::array::forcecast>::ensure(array);
}

}  // namespace surefoot::python
