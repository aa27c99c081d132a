// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Files made byte by byte, by code that knows nothing of the readers.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace surefoot::io::test {

/// A folder that goes with the test.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "surefoot_XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Writes a file into it, with the folders above it.
  std::filesystem::path write(const std::string& name, std::string_view content) const {
    const std::filesystem::path file = path_ / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary).write(content.data(), std::ssize(content));
    return file;
  }

 private:
  std::filesystem::path path_;
};

inline std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

inline std::span<const std::byte> bytes_of(std::string_view text) {
  return {reinterpret_cast<const std::byte*>(text.data()), text.size()};
}

template <typename T>
std::string little(T value) {
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &value, sizeof(T));
  return bytes;
}

template <typename T>
std::string big(T value) {
  std::string bytes = little(value);
  std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

/// The message of the exception of type E that `action` throws; empty: none.
template <typename E, typename Action>
std::string message_of(Action&& action) {
  try {
    action();
  } catch (const E& error) {
    return error.what();
  }
  return {};
}

struct Measured {
  std::uint16_t distance;  ///< [2 mm]
  std::uint8_t reflectivity;
};
/// What a VLP-16 measures: by block (0..11) and channel (0..31).
using Measure = std::function<Measured(std::size_t, std::size_t)>;

/// A VLP-16 data packet from its manual: `azimuth` of the first block and `step` between blocks of
/// different azimuth [0.01 deg]; in dual mode (0x39) two blocks share one.
inline std::string vlp16_payload(unsigned azimuth, unsigned step, std::uint32_t past_hour_us,
                                 unsigned mode, const Measure& measure, unsigned product = 0x22) {
  std::string payload;
  for (std::size_t block = 0; block < 12; ++block) {
    const auto turns = static_cast<unsigned>(mode == 0x39 ? block / 2 : block);
    payload += "\xff\xee" + little(static_cast<std::uint16_t>((azimuth + turns * step) % 36000));
    for (std::size_t channel = 0; channel < 32; ++channel) {
      const Measured measured = measure(block, channel);
      payload += little(measured.distance) + little(measured.reflectivity);
    }
  }
  return payload + little(past_hour_us) + static_cast<char>(mode) + static_cast<char>(product);
}

/// An IPv4 UDP packet, with `option_words` words of IP options.
inline std::string ip_packet(std::string_view payload, std::uint16_t port,
                             unsigned option_words = 0, unsigned protocol = 17) {
  const auto udp_size = static_cast<std::uint16_t>(payload.size() + 8);
  const auto ip_size = static_cast<std::uint16_t>(udp_size + 20 + 4 * option_words);
  std::string ip;
  ip += static_cast<char>(0x45 + option_words);
  ip += '\0';
  ip += big(ip_size) + std::string(4, '\0') + '\x40' + static_cast<char>(protocol);
  ip += std::string(2, '\0') + std::string("\xc0\xa8\x01\xc9\xff\xff\xff\xff", 8);
  ip += std::string(4 * option_words, '\x01');
  return ip + big(port) + big(port) + big(udp_size) + std::string(2, '\0') + std::string(payload);
}

/// An Ethernet frame around it, with VLAN tags.
inline std::string ethernet_frame(std::string_view ip, unsigned vlan_tags = 0) {
  std::string frame(12, '\x02');
  for (unsigned i = 0; i < vlan_tags; ++i) {
    frame += std::string("\x81\x00\x00\x05", 4);
  }
  return frame + std::string("\x08\x00", 2) + std::string(ip);
}

/// A pcap file, frame by frame.
class PcapFile {
 public:
  explicit PcapFile(std::uint32_t link_type = 1, bool nanoseconds = false, bool big_endian = false)
      : nanoseconds_(nanoseconds), big_endian_(big_endian) {
    content_ = number(nanoseconds ? 0xa1b23c4dU : 0xa1b2c3d4U) + number(std::uint16_t{2}) +
               number(std::uint16_t{4}) + number(0U) + number(0U) + number(65535U) +
               number(link_type);
  }
  void add(std::int64_t stamp_ns, std::string_view frame, std::size_t cut_by = 0) {
    const std::int64_t fraction = stamp_ns % 1'000'000'000 / (nanoseconds_ ? 1 : 1000);
    content_ += number(static_cast<std::uint32_t>(stamp_ns / 1'000'000'000)) +
                number(static_cast<std::uint32_t>(fraction)) +
                number(static_cast<std::uint32_t>(frame.size() - cut_by)) +
                number(static_cast<std::uint32_t>(frame.size())) +
                std::string(frame.substr(0, frame.size() - cut_by));
  }
  [[nodiscard]] const std::string& content() const { return content_; }

 private:
  template <typename T>
  [[nodiscard]] std::string number(T value) const {
    return big_endian_ ? big(value) : little(value);
  }
  bool nanoseconds_, big_endian_;
  std::string content_;
};

/// A pcapng file: a section header, one interface and a packet block a frame.
class PcapngFile {
 public:
  /// `decimals`: of the stamps, said by the interface's if_tsresol; 6, the default, is not said.
  /// `begin_s`: what they count from, said by its if_tsoffset.
  explicit PcapngFile(std::uint16_t link_type = 1, unsigned decimals = 6, bool big_endian = false,
                      std::int64_t begin_s = 0)
      : ticks_ns_(1), big_endian_(big_endian) {
    for (unsigned i = decimals; i < 9; ++i) ticks_ns_ *= 10;
    add_block(0x0a0d0d0aU, number(0x1a2b3c4dU) + number(std::uint16_t{1}) +
                               number(std::uint16_t{0}) + number(~std::uint64_t{0}));
    std::string options;
    if (decimals != 6) {
      constexpr std::uint16_t kTimeResolution = 9;
      options = number(kTimeResolution) + number(std::uint16_t{1}) + static_cast<char>(decimals) +
                std::string(3, '\0');
    }
    if (begin_s != 0) {
      constexpr std::uint16_t kTimeOffset = 14;
      options += number(kTimeOffset) + number(std::uint16_t{8}) + number(begin_s);
    }
    if (!options.empty()) options += number(0U);
    add_block(1, number(link_type) + number(std::uint16_t{0}) + number(65535U) + options);
  }
  void add(std::int64_t stamp_ns, std::string_view frame) {
    add_ticks(static_cast<std::uint64_t>(stamp_ns / ticks_ns_), frame);
  }
  /// In the resolution that the file says, of which `add` knows 10^-9 to 1 s.
  void add_ticks(std::uint64_t ticks, std::string_view frame) {
    const auto size = static_cast<std::uint32_t>(frame.size());
    add_block(6, number(0U) + number(static_cast<std::uint32_t>(ticks >> 32)) +
                     number(static_cast<std::uint32_t>(ticks)) + number(size) + number(size) +
                     std::string(frame));
  }
  [[nodiscard]] const std::string& content() const { return content_; }

 private:
  void add_block(std::uint32_t type, std::string body) {
    body.resize((body.size() + 3) / 4 * 4, '\0');
    const std::string length = number(static_cast<std::uint32_t>(body.size() + 12));
    content_ += number(type) + length + body + length;
  }
  template <typename T>
  [[nodiscard]] std::string number(T value) const {
    return big_endian_ ? big(value) : little(value);
  }
  std::int64_t ticks_ns_;
  bool big_endian_;
  std::string content_;
};

}  // namespace surefoot::io::test
