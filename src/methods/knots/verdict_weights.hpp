// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Written by benchmarks/fit_verdict; docs/reliability.md tells from what.
#pragma once

#include "surefoot/estimate.hpp"

namespace surefoot {

inline constexpr Evidence kVerdictWeights{.misfit = 1.093,
                                          .unseen = 0.295,
                                          .contradiction = 1.756,
                                          .motion = 1.040,
                                          .unconverged = 1.880,
                                          .uncertainty = 2.144,
                                          .gap = 1.675,
                                          .frozen = 6.487,
                                          .rival = 2.732};
/// Share of wrong poses in the mix that the probability is for.
inline constexpr double kVerdictBase = 0.01;
inline constexpr double kVerdictOffset = -8.675;

}  // namespace surefoot
