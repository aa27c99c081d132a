// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A bag's packets into a capture, for programs that read those.
#pragma once

#include "io/conversion.hpp"

namespace surefoot::io {

/// The packets of one topic, byte for byte and with the stamps that the driver gave them. Scans are
/// chosen as for every other conversion. Throws as convert_recording(), ReadError where the topic's
/// messages hold points.
[[nodiscard]] ConversionOutcome convert_bag_packets(const ConversionRequest& request,
                                                    const ConversionListener& listener);

}  // namespace surefoot::io
