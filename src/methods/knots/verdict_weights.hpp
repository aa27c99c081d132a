// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Written by benchmarks/fit_verdict; docs/reliability.md tells from what.
#pragma once

#include "surefoot/estimate.hpp"

namespace surefoot {

inline constexpr Evidence kVerdictWeights{.misfit = 1.073,
                                          .unseen = 0.586,
                                          .contradiction = 1.776,
                                          .motion = 0.791,
                                          .unconverged = 1.739,
                                          .uncertainty = 2.169,
                                          .gap = 0.886,
                                          .frozen = 6.452,
                                          .rival = 1.837};
/// Share of wrong poses in the mix that the probability is for.
inline constexpr double kVerdictBase = 0.01;
inline constexpr double kVerdictOffset = -8.660;

}  // namespace surefoot
