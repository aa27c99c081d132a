// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A scan's arrays where a caller of another language keeps them.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "surefoot/scan.hpp"

namespace surefoot::bindings {

/// Values that lie a fixed number of bytes apart, as somebody else keeps them: a vector, a message,
/// a column of an array. They need not be aligned.
template <typename T>
struct StridedView {
  const std::byte* first = nullptr;
  std::size_t size = 0;
  std::ptrdiff_t stride = sizeof(T);  ///< [bytes]

  StridedView() = default;
  StridedView(const void* begin, std::size_t count, std::ptrdiff_t bytes_apart = sizeof(T))
      : first(static_cast<const std::byte*>(begin)), size(count), stride(bytes_apart) {}

  [[nodiscard]] T operator[](std::size_t i) const {
    T value;
    std::memcpy(static_cast<void*>(&value), first + static_cast<std::ptrdiff_t>(i) * stride,
                sizeof(T));
    return value;
  }
};

/// A Scan whose arrays lie elsewhere.
struct ScanView {
  std::int64_t stamp_ns = 0;
  StridedView<Eigen::Vector3f> points;
  StridedView<float> intensities;
  StridedView<std::int32_t> times_ns;
  StridedView<std::uint16_t> rings;
};

template <typename T>
[[nodiscard]] std::vector<T> values_of(const StridedView<T>& view) {
  std::vector<T> values;
  values.reserve(view.size);
  for (std::size_t i = 0; i < view.size; ++i) values.push_back(view[i]);
  return values;
}

/// What the library takes; the one time that the arrays are read.
[[nodiscard]] inline Scan scan_of(const ScanView& view) {
  Scan scan;
  scan.stamp_ns = view.stamp_ns;
  scan.points = values_of(view.points);
  scan.intensities = values_of(view.intensities);
  scan.times_ns = values_of(view.times_ns);
  scan.rings = values_of(view.rings);
  return scan;
}

}  // namespace surefoot::bindings
