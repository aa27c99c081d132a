// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Scans as they come, whatever they are made of: a sensor's packets, or messages on a topic.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/recording.hpp"
#include "live/datagram_source.hpp"
#include "live/topic_source.hpp"

namespace surefoot::live {

struct LiveScan {
  io::ScanItem item;
  std::chrono::steady_clock::time_point received;  ///< the last that it is made of
};

/// Of a stream so far.
struct StreamState {
  std::size_t received = 0;  ///< datagrams or messages
  std::uint64_t lost = 0;    ///< before they were received
  io::CaptureCounts packets;
  std::vector<std::string> notes;
  std::string description;
};

class ScanStream {
 public:
  virtual ~ScanStream() = default;

  /// Waits for the next scan, and asks ten times a second at least whether to go on. Where not, the
  /// scans that are left are given, then nothing. Throws io::ReadError, io::WriteError.
  [[nodiscard]] virtual std::optional<LiveScan> next(const std::function<bool()>& go_on) = 0;
  [[nodiscard]] virtual StreamState state() const = 0;
  /// When something came last; nothing before the first.
  [[nodiscard]] virtual std::optional<std::chrono::steady_clock::time_point> last() const = 0;
  /// Whether it waits for a slow receiver instead of losing anything.
  [[nodiscard]] virtual bool patient() const = 0;
  /// At the end: why no scan could be made at all; empty where one could.
  [[nodiscard]] virtual std::string nothing_text() const = 0;
};

/// @param metadata of an Ouster, say. @param record a capture of all datagrams; empty: none.
[[nodiscard]] std::unique_ptr<ScanStream> packet_stream(std::unique_ptr<DatagramSource> source,
                                                        const io::OpenOptions& options,
                                                        std::string metadata,
                                                        const std::filesystem::path& record);

/// Stamps are mended at once where the options let them be mended. @param record an MCAP file of
/// all messages; empty: none.
[[nodiscard]] std::unique_ptr<ScanStream> topic_stream(std::unique_ptr<TopicSource> source,
                                                       const io::OpenOptions& options,
                                                       const std::filesystem::path& record);

}  // namespace surefoot::live
