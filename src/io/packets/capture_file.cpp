// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/packets/capture_file.hpp"

#include <pcap/pcap.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "io/bags/compression.hpp"
#include "io/file_reader.hpp"
#include "io/recording.hpp"

namespace surefoot::io {
namespace {

template <typename Handle>
pcap_t* pcap_of(const Handle& handle) {
  return static_cast<pcap_t*>(handle.get());
}

LinkLayer link_layer(int type) {
  switch (type) {
    case DLT_EN10MB:
      return LinkLayer::ethernet;
    case DLT_LINUX_SLL:
      return LinkLayer::linux_cooked;
    case DLT_LINUX_SLL2:
      return LinkLayer::linux_cooked2;
    case DLT_NULL:
    case DLT_LOOP:
      return LinkLayer::loopback;
    case DLT_RAW:
    case DLT_IPV4:
      return LinkLayer::raw_ip;
    default:
      break;
  }
  const char* name = pcap_datalink_val_to_name(type);
  throw ReadError("capture of link layer " + std::to_string(type) + " (" +
                  (name != nullptr ? name : "unknown") +
                  "); expected Ethernet, Linux cooked, loopback or raw IPv4");
}

/// pcapng counts seconds in 64 bits, to begin anywhere. Within this many of 1970 (the years 1827 to
/// 2112, all that classic captures can say) stamps and their differences are whole nanoseconds.
constexpr std::int64_t kFarthestSecond = 4'500'000'000;

}  // namespace

/// Bytes, as of a compressed capture, as the stream of C that libpcap asks for.
struct CaptureFile::Unpacked {
  std::unique_ptr<ByteStream> stream;
  std::string error = {};  ///< that nothing may throw through libpcap

  /// Null where there is no memory for it.
  std::FILE* open() { return fopencookie(this, "rb", {read, nullptr, nullptr, nullptr}); }
  static ssize_t read(void* cookie, char* to, std::size_t size) {
    auto& self = *static_cast<Unpacked*>(cookie);
    try {
      return static_cast<ssize_t>(self.stream->read({reinterpret_cast<std::byte*>(to), size}));
    } catch (const std::exception& error) {
      self.error = error.what();
      errno = EIO;
      return -1;
    }
  }
};

void CaptureFile::Forget::operator()(Unpacked* unpacked) const { delete unpacked; }

void CaptureFile::Close::operator()(void* handle) const {
  pcap_close(static_cast<pcap_t*>(handle));
}

CaptureFile::CaptureFile(const std::filesystem::path& file) {
  require_regular_file(file);
  std::array<std::byte, 16> begin{};
  const std::size_t got = FileStream(file).read(begin);
  const bool packed = compression_by_content(std::span(begin).first(got)) != Compression::none;
  if (packed) unpacked_.reset(new Unpacked{open_stream(file)});
  std::FILE* opened = packed ? unpacked_->open() : std::fopen(file.c_str(), "rb");
  if (opened == nullptr) {
    throw ReadError(std::string("cannot read it: ") + std::strerror(errno));
  }
  open(opened);
}

CaptureFile::CaptureFile(std::FILE* file) { open(file); }

CaptureFile::CaptureFile(std::unique_ptr<ByteStream> bytes) {
  unpacked_.reset(new Unpacked{std::move(bytes)});
  std::FILE* opened = unpacked_->open();
  if (opened == nullptr) throw ReadError(std::string("cannot read it: ") + std::strerror(errno));
  std::setvbuf(opened, nullptr, _IONBF, 0);
  open(opened);
}

void CaptureFile::open(std::FILE* file) {
  if (!unpacked_) {
    std::fseek(file, 0, SEEK_END);
    size_ = static_cast<double>(std::ftell(file));
    std::rewind(file);
  }
  char message[PCAP_ERRBUF_SIZE] = "";
  handle_.reset(
      pcap_fopen_offline_with_tstamp_precision(file, PCAP_TSTAMP_PRECISION_NANO, message));
  if (!handle_) {
    std::fclose(file);
    throw ReadError("no pcap or pcapng capture: " +
                    (unpacked_ && !unpacked_->error.empty() ? unpacked_->error : message));
  }
  link_ = link_layer(pcap_datalink(pcap_of(handle_)));
}

std::optional<CapturedFrame> CaptureFile::next() {
  pcap_pkthdr* header = nullptr;
  const unsigned char* data = nullptr;
  const int result = pcap_next_ex(pcap_of(handle_), &header, &data);
  if (result != 1) {
    if (result == PCAP_ERROR) fail();
    return std::nullopt;
  }
  const auto seconds = static_cast<std::int64_t>(header->ts.tv_sec);
  if (seconds < -kFarthestSecond || seconds > kFarthestSecond) {
    cut_short_ = "a packet is stamped " + std::to_string(seconds) +
                 " s after 1970; expected at most " + std::to_string(kFarthestSecond) +
                 " s before or after";
    return std::nullopt;
  }
  CapturedFrame frame;
  // With nanosecond precision tv_usec holds nanoseconds.
  frame.stamp_ns = seconds * 1'000'000'000 + static_cast<std::int64_t>(header->ts.tv_usec);
  frame.length = header->len;
  frame.bytes = {reinterpret_cast<const std::byte*>(data), header->caplen};
  return frame;
}

void CaptureFile::fail() {
  const bool damaged = unpacked_ && !unpacked_->error.empty();
  cut_short_ = damaged ? unpacked_->error : pcap_geterr(pcap_of(handle_));
}

double CaptureFile::progress() const {
  if (unpacked_) return unpacked_->stream->progress();
  const long position = std::ftell(pcap_file(pcap_of(handle_)));
  return size_ > 0.0 ? std::clamp(static_cast<double>(position) / size_, 0.0, 1.0) : 1.0;
}

}  // namespace surefoot::io
