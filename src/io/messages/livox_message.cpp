// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/messages/livox_message.hpp"

#include <array>
#include <cstdlib>

#include "io/recording.hpp"

namespace surefoot::io {
namespace {

struct Member {
  const char* name;
  ScalarType type;
  std::size_t offset;
};
constexpr std::array<Member, 7> kMembers = {{{"offset_time", ScalarType::u32, 0},
                                             {"x", ScalarType::f32, 4},
                                             {"y", ScalarType::f32, 8},
                                             {"z", ScalarType::f32, 12},
                                             {"reflectivity", ScalarType::u8, 16},
                                             {"tag", ScalarType::u8, 17},
                                             {"line", ScalarType::u8, 18}}};
constexpr std::size_t kPointBytes = 19;
constexpr std::int64_t kSameClockNs = 1'000'000'000;

}  // namespace

CloudMessage read_livox_message(MessageReader& reader) {
  CloudMessage cloud;
  reader.begin_structure();
  const MessageHeader header = read_header(reader);
  cloud.frame = header.frame;
  const auto time_base = static_cast<std::int64_t>(reader.number<std::uint64_t>("time base"));
  std::int64_t difference = 0;
  const bool overflow = __builtin_sub_overflow(time_base, header.stamp_ns, &difference);
  const bool same_clock = !overflow && difference > -kSameClockNs && difference < kSameClockNs;
  cloud.stamp_ns = same_clock ? time_base : header.stamp_ns;
  (void)reader.number<std::uint32_t>("number of points");
  // And three reserved bytes.
  cloud.lidar = std::to_integer<unsigned>(reader.take(4, "LiDAR's number").front());
  const auto count = reader.structures("points", kPointBytes);
  // In CDR the next point's first number is aligned to 4; delimited structures have their size
  // first.
  if (reader.is_delimited()) throw ReadError("Livox points in delimited CDR 2 are not read");
  const std::size_t stride = reader.is_cdr() ? 20 : kPointBytes;
  const std::uint64_t bytes = count == 0 ? 0 : (count - std::uint64_t{1}) * stride + kPointBytes;
  const std::byte* const first = reader.take(bytes, "points").data();
  cloud.table.format = "Livox CustomMsg";
  cloud.table.size = count;
  for (const Member& member : kMembers) {
    cloud.table.columns.push_back({member.name, member.type,
                                   count > 0 ? first + member.offset : nullptr, stride,
                                   reader.is_swapped()});
  }
  return cloud;
}

}  // namespace surefoot::io
