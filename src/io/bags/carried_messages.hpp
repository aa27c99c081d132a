// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Messages of a bag that no scans are made of (IMU, transforms, images), copied to another as they
// are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "io/bags/bag_writer.hpp"
#include "io/bags/message_source.hpp"

namespace surefoot::io {

class CarriedMessages {
 public:
  /// @param but topics that are left out; @param only where not empty, the topics that are copied.
  /// Throws ReadError.
  CarriedMessages(const std::filesystem::path& bag, std::set<std::string> but,
                  std::set<std::string> only);

  /// Copies what lies before the first message that was recorded after `upto_ns`. What was recorded
  /// before `from_ns` is left out, but for what latched topics said, as transforms that never
  /// change. Throws WriteError.
  void copy(BagWriter& to, std::int64_t from_ns, std::int64_t upto_ns);
  /// The same of all of the bag, for the last time: what is earlier may lie behind what is later.
  /// Given up where `interrupted`.
  void copy_the_rest(
      BagWriter& to, std::int64_t from_ns, std::int64_t upto_ns,
      const std::function<bool()>& interrupted = [] { return false; });

  [[nodiscard]] std::size_t messages() const { return messages_; }
  [[nodiscard]] std::size_t topics() const;
  /// What the output does not have, a line each.
  [[nodiscard]] std::vector<std::string> losses() const;
  [[nodiscard]] const std::vector<std::string>& notes() const { return bag_->notes(); }

 private:
  struct Way {
    std::optional<std::size_t> topic;  ///< of the output; nothing where it cannot be
    std::size_t messages = 0;
    std::string why;  ///< not
    bool without_text = false;
  };
  using Key = std::pair<std::string, std::string>;  ///< name and type

  [[nodiscard]] bool is_meant(const Topic& topic) const;
  [[nodiscard]] static Way way_of(const Topic& topic, BagWriter& to);

  std::unique_ptr<MessageSource> bag_;
  std::set<std::string> but_, only_;
  std::optional<Message> next_;
  bool ended_ = false;
  std::map<Key, Way> ways_;
  std::size_t messages_ = 0;
};

}  // namespace surefoot::io
