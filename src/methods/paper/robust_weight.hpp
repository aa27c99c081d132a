// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

namespace surefoot {

/// w: squared Lorentzian weight of a residual's norm [m] with scale kappa [m], eq. (19).
[[nodiscard]] inline double lorentzian_weight(double residual_norm, double kappa) {
  const double ratio = kappa / (kappa + residual_norm);
  return ratio * ratio;  // [Eq 19]
}

}  // namespace surefoot
