// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/packets/frame_writer.hpp"

#include <pcap/pcap.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "io/file_writer.hpp"

namespace surefoot::io {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;
constexpr std::int64_t kEndOfStamps = std::int64_t{1} << 32;  // [s], without a sign

}  // namespace

void FrameWriter::Close::operator()(void* dump) const {
  pcap_dump_close(static_cast<pcap_dumper_t*>(dump));
}

FrameWriter::FrameWriter(const std::filesystem::path& file, const CaptureFile& like) : path_(file) {
  auto* const handle = static_cast<pcap_t*>(like.handle());
  dump_.reset(pcap_dump_open(handle, file.c_str()));
  if (!dump_) throw WriteError(std::string("cannot write it: ") + pcap_geterr(handle));
}

bool FrameWriter::add(const CapturedFrame& frame) {
  if (frame.stamp_ns < 0 || frame.stamp_ns / kSecond >= kEndOfStamps) return false;
  pcap_pkthdr header{};
  header.ts.tv_sec = frame.stamp_ns / kSecond;
  header.ts.tv_usec = frame.stamp_ns % kSecond;  // nanoseconds, as those that it is like
  header.caplen = static_cast<bpf_u_int32>(frame.bytes.size());
  header.len = frame.length;
  pcap_dump(reinterpret_cast<unsigned char*>(dump_.get()), &header,
            reinterpret_cast<const unsigned char*>(frame.bytes.data()));
  if (std::ferror(pcap_dump_file(static_cast<pcap_dumper_t*>(dump_.get()))) != 0) fail();
  return true;
}

void FrameWriter::finish() {
  if (pcap_dump_flush(static_cast<pcap_dumper_t*>(dump_.get())) != 0) fail();
}

void FrameWriter::fail() const {
  throw WriteError(path_.string() + ": cannot write it: " + std::strerror(errno));
}

}  // namespace surefoot::io
