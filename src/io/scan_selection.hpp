// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The scans of a recording that another run has used, told by their stamps.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "io/recording.hpp"

namespace surefoot::io {

/// The recording without the scans whose stamps are not among `stamps_ns`, which grow. A note at
/// the end tells stamps that no scan had.
[[nodiscard]] std::unique_ptr<Recording> select_scans(std::unique_ptr<Recording> recording,
                                                      std::vector<std::int64_t> stamps_ns);

}  // namespace surefoot::io
