// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/scene.hpp"

namespace surefoot::benchmarks {

/// Four streets around a block of 400 m x 250 m, 1.3 km round: longer than any local map is wide,
/// so that a walk through them keeps leaving what it has seen.
[[nodiscard]] simulation::Scene town();

}  // namespace surefoot::benchmarks
