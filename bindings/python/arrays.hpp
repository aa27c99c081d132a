// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// C++ vectors as numpy arrays that look into them.
#pragma once

#include <pybind11/numpy.h>

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "bindings.hpp"

namespace surefoot::python {

/// Keeps what an array looks into alive for as long as the array.
template <typename Value>
py::capsule keep_alive(std::unique_ptr<Value> value) {
  return py::capsule(value.release(), [](void* kept) { delete static_cast<Value*>(kept); });
}

/// The vector's memory as an array (N,), handed over.
template <typename Number>
py::array_t<Number> array_of(std::vector<Number> values) {
  auto kept = std::make_unique<std::vector<Number>>(std::move(values));
  const auto size = static_cast<py::ssize_t>(kept->size());
  const Number* const data = kept->data();
  return py::array_t<Number>({size}, {static_cast<py::ssize_t>(sizeof(Number))}, data,
                             keep_alive(std::move(kept)));
}

/// The same for points: (N, 3).
template <typename Number>
py::array_t<Number> array_of(std::vector<Eigen::Matrix<Number, 3, 1>> points) {
  using Points = std::vector<Eigen::Matrix<Number, 3, 1>>;
  auto kept = std::make_unique<Points>(std::move(points));
  const auto size = static_cast<py::ssize_t>(kept->size());
  const auto* const data = reinterpret_cast<const Number*>(kept->data());
  constexpr auto kNumber = static_cast<py::ssize_t>(sizeof(Number));
  return py::array_t<Number>({size, py::ssize_t{3}}, {3 * kNumber, kNumber}, data,
                             keep_alive(std::move(kept)));
}

/// "(100, 4) float64", for messages.
inline std::string shape_of(const py::array& array) {
  std::string text = "(";
  for (py::ssize_t i = 0; i < array.ndim(); ++i) {
    text += (i > 0 ? ", " : "") + std::to_string(array.shape(i));
  }
  return text + (array.ndim() == 1 ? ",) " : ") ") + std::string(py::str(array.dtype()));
}

}  // namespace surefoot::python
