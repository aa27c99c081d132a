// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "dataset/capture_file.hpp"

#include <pcap/pcap.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "dataset/file_reader.hpp"
#include "dataset/recording.hpp"

namespace surefoot::dataset {
namespace {

template <typename Handle>
pcap_t* pcap_of(const Handle& handle) {
  return static_cast<pcap_t*>(handle.get());
}

LinkLayer link_layer(int type) {
  switch (type) {
    case DLT_EN10MB:
      return LinkLayer::kEthernet;
    case DLT_LINUX_SLL:
      return LinkLayer::kLinuxCooked;
    case DLT_LINUX_SLL2:
      return LinkLayer::kLinuxCooked2;
    case DLT_NULL:
    case DLT_LOOP:
      return LinkLayer::kLoopback;
    case DLT_RAW:
    case DLT_IPV4:
      return LinkLayer::kRawIp;
    default:
      break;
  }
  const char* name = pcap_datalink_val_to_name(type);
  throw ReadError("capture of link layer " + std::to_string(type) + " (" +
                  (name != nullptr ? name : "unknown") +
                  "); expected Ethernet, Linux cooked, loopback or raw IPv4");
}

}  // namespace

void CaptureFile::Close::operator()(void* handle) const {
  pcap_close(static_cast<pcap_t*>(handle));
}

CaptureFile::CaptureFile(const std::filesystem::path& file) {
  require_regular_file(file);
  std::FILE* opened = std::fopen(file.c_str(), "rb");
  if (opened == nullptr) {
    throw ReadError(std::string("cannot read it: ") + std::strerror(errno));
  }
  open(opened);
}

CaptureFile::CaptureFile(std::FILE* file) { open(file); }

void CaptureFile::open(std::FILE* file) {
  std::fseek(file, 0, SEEK_END);
  size_ = static_cast<double>(std::ftell(file));
  std::rewind(file);
  char message[PCAP_ERRBUF_SIZE] = "";
  handle_.reset(
      pcap_fopen_offline_with_tstamp_precision(file, PCAP_TSTAMP_PRECISION_NANO, message));
  if (!handle_) {
    std::fclose(file);
    throw ReadError(std::string("no pcap or pcapng capture: ") + message);
  }
  link_ = link_layer(pcap_datalink(pcap_of(handle_)));
}

std::optional<CapturedFrame> CaptureFile::next() {
  pcap_pkthdr* header = nullptr;
  const unsigned char* data = nullptr;
  const int result = pcap_next_ex(pcap_of(handle_), &header, &data);
  if (result != 1) {
    cut_short_ = result == PCAP_ERROR ? pcap_geterr(pcap_of(handle_)) : "";
    return std::nullopt;
  }
  CapturedFrame frame;
  // With nanosecond precision tv_usec holds nanoseconds.
  frame.stamp_ns = static_cast<std::int64_t>(header->ts.tv_sec) * 1'000'000'000 +
                   static_cast<std::int64_t>(header->ts.tv_usec);
  frame.bytes = {reinterpret_cast<const std::byte*>(data), header->caplen};
  return frame;
}

double CaptureFile::progress() const {
  const long position = std::ftell(pcap_file(pcap_of(handle_)));
  return size_ > 0.0 ? std::clamp(static_cast<double>(position) / size_, 0.0, 1.0) : 1.0;
}

}  // namespace surefoot::dataset
