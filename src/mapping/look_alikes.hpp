// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Whether two places that fit would fit otherwise, too. Within a walk the odometry tells; between
// two maps nothing does.
#pragma once

#include "mapping/loop_verifier.hpp"

namespace surefoot::mapping {

/// Whether they fit as well the other way round, or a quarter turned.
[[nodiscard]] bool fits_turned(const LoopCheck& check, const VerifiableSubmap& place,
                               const VerifiableSubmap& seen, const LoopLimits& limits);

/// The largest overlap_between() of them some metres aside of or along from where they fit. What
/// repeats so near is expected to repeat farther off as well, where neither of them sees it.
[[nodiscard]] double overlap_slid(const LoopCheck& check, const VerifiableSubmap& place,
                                  const VerifiableSubmap& seen);

}  // namespace surefoot::mapping
