// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Packet captures of a VLP-16, byte by byte from its manual and from the capture formats.
#pragma once

#include <string>
#include <vector>

namespace surefoot::test {

/// Data packets (1206 bytes) of a VLP-16 at 600 rpm that stands in a hall, single return.
[[nodiscard]] std::vector<std::string> vlp16_packets(int revolutions);

/// The packets as UDP datagrams in Ethernet frames, stamped at the sensor's packet rate.
[[nodiscard]] std::string pcap_file(const std::vector<std::string>& packets);
[[nodiscard]] std::string pcapng_file(const std::vector<std::string>& packets);

}  // namespace surefoot::test
