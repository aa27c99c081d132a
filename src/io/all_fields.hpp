// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "io/recording.hpp"
#include "io/scan_builder.hpp"

namespace surefoot::io {

/// What a table holds besides the scan that was built from it, for those who write it anew: the
/// fields that a scan has no room for, and in `item.losses` what neither has.
void take_all_fields(const PointTable& table, const ScanColumns& columns, const BuiltScan& built,
                     ScanItem& item);

}  // namespace surefoot::io
