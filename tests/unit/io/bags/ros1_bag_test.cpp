// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// ROS 1 bags made byte by byte from the format's description.
#include <bzlib.h>
#include <gtest/gtest.h>

#include "io/bags/bag_writer.hpp"
#include "io/bags/compression.hpp"
#include "io/bags/ros1_bag_format.hpp"
#include "io/bags/ros1_bag_reader.hpp"
#include "io/recording.hpp"
#include "unit/io/bags/support.hpp"

namespace surefoot::io {
namespace {

using test::little;
using test::ReadMessage;

std::string sized(const std::string& bytes) {
  return little(static_cast<std::uint32_t>(bytes.size())) + bytes;
}
std::string record(const std::vector<std::string>& fields, const std::string& data) {
  std::string header;
  for (const std::string& field : fields) header += sized(field);
  return sized(header) + sized(data);
}
std::string op(int number) { return std::string("op=") + static_cast<char>(number); }
std::string ros1_u32(std::uint32_t value) { return little(value); }

std::string connection(std::uint32_t id, const std::string& topic, const std::string& type) {
  return record({op(7), "conn=" + ros1_u32(id), "topic=" + topic},
                sized("topic=" + topic) + sized("type=" + type) + sized("md5sum=0"));
}
std::string message(std::uint32_t id, std::uint32_t seconds, const std::string& data) {
  return record({op(2), "conn=" + ros1_u32(id), "time=" + ros1_u32(seconds) + ros1_u32(7)}, data);
}
std::string chunk(const std::string& name, const std::string& content,
                  const std::string& compressed) {
  return record({op(5), "compression=" + name,
                 "size=" + ros1_u32(static_cast<std::uint32_t>(content.size()))},
                compressed);
}
std::string file_header() {
  return "#ROSBAG V2.0\n" +
         record({op(3), "index_pos=" + little(std::uint64_t{0})}, std::string(200, ' '));
}

std::string bzip2(const std::string& content) {
  std::string out(content.size() + 700, '\0');
  auto size = static_cast<unsigned>(out.size());
  BZ2_bzBuffToBuffCompress(out.data(), &size, const_cast<char*>(content.data()),
                           static_cast<unsigned>(content.size()), 9, 0, 0);
  return out.substr(0, size);
}

std::string content(int first) {
  std::string bytes = connection(0, "/a", "pkg/A") + connection(1, "/b", "pkg/B");
  for (int i = first; i < first + 4; ++i) {
    bytes += message(static_cast<std::uint32_t>(i % 2), static_cast<std::uint32_t>(100 + i),
                     std::string(50, static_cast<char>('a' + i)));
  }
  return bytes;
}

ReadMessage expected_of_ros1(int i) {
  return {i % 2 == 0 ? "/a" : "/b", i % 2 == 0 ? "pkg/A" : "pkg/B", (100 + i) * 1'000'000'000LL + 7,
          std::string(50, static_cast<char>('a' + i))};
}

std::string bag(const std::string& name) {
  const auto pack = [&name](const std::string& bytes) {
    return name == "bz2" ? bzip2(bytes) : name == "lz4" ? compress(Compression::lz4, bytes) : bytes;
  };
  const std::string index =
      record({op(4), "ver=" + ros1_u32(1), "conn=" + ros1_u32(0), "count=" + ros1_u32(0)}, "");
  return file_header() + chunk(name, content(0), pack(content(0))) + index +
         chunk(name, content(4), pack(content(4))) + index + connection(0, "/a", "pkg/A");
}

struct Ros1Outcome {
  std::vector<ReadMessage> messages;
  std::string notes;
};
Ros1Outcome read_ros1(const std::string& bytes) {
  const auto source = read_ros1_bag(std::make_unique<MemoryStream>(test::bytes_of(bytes)));
  Ros1Outcome outcome{test::read_all_messages(*source), {}};
  outcome.notes = test::joined(source->notes());
  return outcome;
}

TEST(Ros1Bag, EveryCompression) {
  for (const char* name : {"none", "bz2", "lz4"}) {
    const Ros1Outcome outcome = read_ros1(bag(name));
    ASSERT_EQ(outcome.messages.size(), 8U) << name;
    for (int i = 0; i < 8; ++i) {
      EXPECT_EQ(outcome.messages[static_cast<std::size_t>(i)], expected_of_ros1(i));
    }
    EXPECT_EQ(outcome.notes, "") << name;
  }
}

TEST(Ros1Bag, CutAnywhere) {
  for (const char* name : {"none", "bz2", "lz4"}) {
    const std::string whole = bag(name);
    std::size_t before = 0;
    for (std::size_t size = kRos1BagMagic.size(); size < whole.size(); ++size) {
      const Ros1Outcome outcome = read_ros1(whole.substr(0, size));
      ASSERT_GE(outcome.messages.size(), before) << size;
      before = outcome.messages.size();
      for (std::size_t i = 0; i < before; ++i) {
        ASSERT_EQ(outcome.messages[i], expected_of_ros1(static_cast<int>(i))) << size;
      }
    }
    EXPECT_EQ(before, 8U);
  }
}

TEST(Ros1Bag, CutIsSaidWhereverItIs) {
  for (const char* name : {"none", "bz2", "lz4"}) {
    const std::string whole = bag(name);
    const std::size_t size = whole.size() * 3 / 4;  // within a chunk
    const std::string notes = read_ros1(whole.substr(0, size)).notes;
    EXPECT_NE(notes.find("cut short"), std::string::npos) << name << ": " << notes;
  }
}

TEST(Ros1Bag, DamagedChunkIsNotedAndTheNextOneRead) {
  std::string bytes = bag("lz4");
  const std::size_t at = bytes.find("\x04\x22\x4d\x18");
  bytes[at] = '\x05';
  const Ros1Outcome outcome = read_ros1(bytes);
  ASSERT_EQ(outcome.messages.size(), 4U);
  EXPECT_EQ(outcome.messages[0], expected_of_ros1(4));
  EXPECT_NE(outcome.notes.find("chunk 0 is damaged"), std::string::npos) << outcome.notes;
}

TEST(Ros1Bag, MessageThatClaimsMoreThanItsChunkHoldsIsNoted) {
  for (const char* name : {"none", "bz2", "lz4"}) {
    std::string inside = content(0);
    const std::size_t data = inside.find(std::string(50, 'b'));
    inside.replace(data - 4, 4, ros1_u32(100'000'000));
    const auto packed = name[0] == 'b'   ? bzip2(inside)
                        : name[0] == 'l' ? compress(Compression::lz4, inside)
                                         : inside;
    const Ros1Outcome outcome = read_ros1(file_header() + chunk(name, inside, packed));
    EXPECT_EQ(outcome.messages.size(), 1U);
    EXPECT_NE(outcome.notes.find("chunk 0 is damaged, read as far as it goes: a record of "
                                 "100000000 bytes"),
              std::string::npos)
        << outcome.notes;
  }
}

TEST(Ros1Bag, ChunkThatHoldsLessThanItSaysIsNoted) {
  const std::string inside = content(0);
  const std::string half = inside.substr(0, connection(0, "/a", "pkg/A").size());
  const std::string notes =
      read_ros1(file_header() + chunk("lz4", inside, compress(Compression::lz4, half))).notes;
  EXPECT_NE(notes.find(std::to_string(inside.size()) + " were announced"), std::string::npos)
      << notes;
}

TEST(Ros1Bag, AnotherCompressionIsNamed) {
  EXPECT_NE(read_ros1(bag("rar")).notes.find("'rar'"), std::string::npos);
}

TEST(Ros1Bag, LengthsThatLieTakeNoMemory) {
  const std::string good = bag("none");
  for (std::size_t at = kRos1BagMagic.size(); at + 4 < good.size(); ++at) {
    std::string bad = good;
    bad.replace(at, 4, ros1_u32(0xf000'0000));
    EXPECT_LE(read_ros1(bad).messages.size(), 8U);
  }
}

TEST(Ros1Bag, SomethingElseIsRefused) {
  EXPECT_THROW((void)read_ros1("#ROSBAG V1.2\n"), ReadError);
  EXPECT_THROW((void)read_ros1(""), ReadError);
}

TEST(Ros1Bag, WhatIsWrittenIsReadBack) {
  const test::TemporaryFolder folder;
  const auto bag = make_ros1_bag(folder.path() / "a.bag");
  const std::size_t topic = bag->add_topic("/points", point_cloud2_definition());
  const std::string large(500'000, 'x');
  for (int i = 0; i < 5; ++i) bag->write(topic, 1'500'000'000 + i, large);
  bag->finish();
  const Ros1Outcome outcome = read_ros1(test::content_of(folder.path() / "a.bag"));
  ASSERT_EQ(outcome.messages.size(), 5U);
  EXPECT_EQ(outcome.messages[4],
            (ReadMessage{"/points", "sensor_msgs/PointCloud2", 1'500'000'004, large}));
  EXPECT_EQ(outcome.notes, "");
}

// As when what is recorded ends by an error.
TEST(Ros1Bag, WhatIsNotFinishedByHandIsWholeToo) {
  const test::TemporaryFolder folder;
  {
    const auto bag = make_ros1_bag(folder.path() / "a.bag");
    bag->write(bag->add_topic("/points", point_cloud2_definition()), 1'500'000'000, "few");
  }
  const Ros1Outcome outcome = read_ros1(test::content_of(folder.path() / "a.bag"));
  ASSERT_EQ(outcome.messages.size(), 1U);
  EXPECT_EQ(outcome.notes, "");
}

}  // namespace
}  // namespace surefoot::io
