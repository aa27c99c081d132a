// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Written by benchmarks/fit_verdict; docs/reliability.md tells from what.
#pragma once

#include "surefoot/estimate.hpp"

namespace surefoot {

inline constexpr Evidence kVerdictWeights{.misfit = 0.529,
                                          .unseen = 0.000,
                                          .contradiction = 2.111,
                                          .motion = 0.609,
                                          .uncertainty = 2.194,
                                          .gap = 0.534,
                                          .unconverged = 2.903,
                                          .frozen = 4.722};
/// Share of wrong poses in the mix that the probability is for.
inline constexpr double kVerdictBase = 0.01;
inline constexpr double kVerdictOffset = -8.396;

}  // namespace surefoot
