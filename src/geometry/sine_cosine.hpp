// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Sines and cosines of many angles that lie close together, for little more than products.
#pragma once

#include <cmath>

namespace surefoot {

/// Sine and cosine of one angle.
struct SineCosine {
  SineCosine() = default;
  /// @param angle [rad].
  explicit SineCosine(double angle) : sine(std::sin(angle)), cosine(std::cos(angle)) {}
  SineCosine(double sine_of, double cosine_of) : sine(sine_of), cosine(cosine_of) {}

  /// Of the sum of two angles.
  [[nodiscard]] SineCosine operator+(const SineCosine& other) const {
    return {sine * other.cosine + cosine * other.sine, cosine * other.cosine - sine * other.sine};
  }

  double sine = 0.0;
  double cosine = 1.0;
};

/// Sines and cosines of angles near a centre: its own, turned by the difference. They are those of
/// the standard library to 2.3e-16, the centre's to the bit.
class SineCosineNear {
 public:
  /// Farther from the centre the standard library is asked [rad].
  static constexpr double kReach = 0.125;

  /// @param centre [rad].
  explicit SineCosineNear(double centre) : centre_(centre), at_centre_(centre) {}

  [[nodiscard]] SineCosine operator()(double angle) const {
    const double x = angle - centre_;
    if (std::abs(x) > kReach) return SineCosine(angle);
    // Taylor's series: the first term left out is 3e-18 of the sine, 3e-20 of the cosine.
    const double xx = x * x;
    const double sine =
        x - x * xx * (1.0 / 6 - xx * (1.0 / 120 - xx * (1.0 / 5040 - xx * (1.0 / 362880))));
    const double one_minus_cosine =
        xx *
        (1.0 / 2 - xx * (1.0 / 24 - xx * (1.0 / 720 - xx * (1.0 / 40320 - xx * (1.0 / 3628800)))));
    // What is added is small, and so is its rounding.
    return {at_centre_.sine + (at_centre_.cosine * sine - at_centre_.sine * one_minus_cosine),
            at_centre_.cosine - (at_centre_.sine * sine + at_centre_.cosine * one_minus_cosine)};
  }

 private:
  double centre_;
  SineCosine at_centre_;
};

}  // namespace surefoot
