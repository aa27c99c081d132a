// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

namespace surefoot::benchmarks {

/// Memory of this process that is resident now (VmRSS) [MB]. Throws std::runtime_error where the
/// system does not say (it is read from /proc).
[[nodiscard]] double resident_megabytes();

}  // namespace surefoot::benchmarks
