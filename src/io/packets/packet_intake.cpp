// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/packets/packet_intake.hpp"

namespace surefoot::io {
namespace {

constexpr std::size_t kPositionPacketBytes = 512;
constexpr std::uint16_t kPositionPort = 8308;

std::string address_text(std::uint32_t address) {
  std::string text;
  for (int shift = 24; shift >= 0; shift -= 8) {
    text += (text.empty() ? "" : ".") + std::to_string(address >> shift & 0xFF);
  }
  return text;
}

}  // namespace

void PacketIntake::add(std::int64_t arrival_ns, const UdpDatagram& datagram) {
  const Stream stream = {datagram.source_address, datagram.destination_port};
  if (datagram.content == FrameContent::truncated) {
    ++counts_.truncated;
  } else if (datagram.content == FrameContent::other) {
    ++counts_.other;
  } else if (datagram.destination_port == kPositionPort &&
             datagram.payload.size() == kPositionPacketBytes) {
    ++counts_.position_packets;
  } else if ((port_ != 0 && datagram.destination_port != port_) ||
             (counts_.data_packets > 0 && stream != stream_)) {
    ++counts_.other;
    remember_traffic(datagram);
    look_for_another(datagram);
  } else {
    use(arrival_ns, datagram);
  }
}

void PacketIntake::use(std::int64_t arrival_ns, const UdpDatagram& datagram) {
  switch (scans_.add(arrival_ns, datagram.payload)) {
    case PacketUse::used:
      // The first sensor's; a second one's would be mixed up with them.
      stream_ = {datagram.source_address, datagram.destination_port};
      data_bytes_ = datagram.payload.size();
      ++counts_.data_packets;
      break;
    case PacketUse::malformed:
      ++counts_.truncated;
      remember_traffic(datagram);
      break;
    case PacketUse::late:
    case PacketUse::other:
      ++counts_.other;
      remember_traffic(datagram);
      break;
  }
}

// From another address: what one sensor sends to another port may be as long and no data.
void PacketIntake::look_for_another(const UdpDatagram& datagram) {
  constexpr std::size_t kMostNamed = 10;
  const Stream stream = {datagram.source_address, datagram.destination_port};
  const bool is_asked = port_ == 0 || datagram.destination_port == port_;
  if (!is_asked || stream.first == stream_.first || datagram.payload.size() != data_bytes_ ||
      others_.size() >= kMostNamed || !others_.insert(stream).second) {
    return;
  }
  notes_.push_back("another " + scans_.sensor() + " at " + address_text(stream.first) + ":" +
                   std::to_string(stream.second) + ", not read" +
                   (stream.second != stream_.second ? " (--udp-port takes another port)" : ""));
}

void PacketIntake::remember_traffic(const UdpDatagram& datagram) {
  constexpr std::size_t kMostKinds = 64;
  if (counts_.data_packets > 0) return;
  const std::pair kind = {datagram.destination_port, datagram.payload.size()};
  if (traffic_.size() < kMostKinds || traffic_.contains(kind)) ++traffic_[kind];
}

CaptureCounts PacketIntake::counts() const {
  CaptureCounts counts = counts_;
  counts.lost = scans_.lost();
  counts.reordered = scans_.reordered();
  return counts;
}

std::string PacketIntake::traffic_seen() const {
  auto most = traffic_.begin();
  for (auto it = traffic_.begin(); it != traffic_.end(); ++it) {
    most = it->second > most->second ? it : most;
  }
  std::string seen;
  if (most != traffic_.end()) {
    seen = "; most are of " + std::to_string(most->first.second) + " bytes to port " +
           std::to_string(most->first.first);
  } else if (counts_.position_packets > 0) {
    seen = "; " + std::to_string(counts_.position_packets) + " of a Velodyne's position, no data";
  } else {
    seen = "; no UDP at all";
  }
  return scans_.reason().empty() ? seen : seen + ": " + scans_.reason();
}

std::string PacketIntake::port_text() const {
  return port_ != 0 ? " to UDP port " + std::to_string(port_) : std::string();
}

}  // namespace surefoot::io
