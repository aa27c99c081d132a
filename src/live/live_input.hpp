// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What a live run reads from and publishes to, opened.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "io/bags/bag_writer.hpp"
#include "io/recording.hpp"
#include "live/command_queue.hpp"
#include "live/scan_stream.hpp"
#include "live/topic_network.hpp"

namespace surefoot::live {

/// A topic, or a capture or bag that is played or still grows, or a port.
struct LiveSource {
  TopicRequest topics;
  std::filesystem::path replay;
  double speed = 1.0;  ///< times its own pace; 0: as fast as it is used
  std::filesystem::path follow;
  std::uint16_t udp = 0;
  std::string address;           ///< of the interface to listen on; empty: all
  std::filesystem::path record;  ///< of all packets or messages; empty: none is made
};

struct LiveInput {
  std::unique_ptr<TopicNetwork> network;  ///< null: none is needed
  std::unique_ptr<ScanStream> stream;
  std::shared_ptr<io::BagWriter> messages;  ///< to the network; null: none
  bool of_topic = false;                    ///< of messages, not of packets
  std::filesystem::path path;               ///< what it is called, and can be opened by if kept
  bool is_kept = false;
  std::vector<std::pair<std::string, std::string>> repeated_by;  ///< options of surefoot run
};

/// Commands of others go to the queue, which has to outlive what is returned. `say` is told what is
/// waited for. Throws io::ReadError, std::runtime_error, std::invalid_argument.
[[nodiscard]] LiveInput open_live_input(const LiveSource& source, const io::OpenOptions& reader,
                                        CommandQueue& commands,
                                        const std::function<void(const std::string&)>& say);

}  // namespace surefoot::live
