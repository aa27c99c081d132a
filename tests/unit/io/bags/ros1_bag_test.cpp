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
  const std::string said = "the file is cut short; what is whole was read\n";
  for (const char* name : {"none", "bz2", "lz4"}) {
    const std::string whole = bag(name);
    const std::size_t last = whole.size() - connection(0, "/a", "pkg/A").size();
    for (const std::size_t size : {std::size_t{100}, whole.size() * 3 / 4,  // within a chunk
                                   last + 2, last + 10, whole.size() - 2}) {
      EXPECT_EQ(read_ros1(whole.substr(0, size)).notes, said) << name << " " << size;
    }
    EXPECT_EQ(read_ros1(whole.substr(0, last)).notes, "") << name;
  }
  const std::string inside = content(0);  // within its last message
  const std::string chunks = file_header() + chunk("none", inside, inside);
  EXPECT_EQ(read_ros1(chunks.substr(0, chunks.size() - 9)).notes, said);
  for (const std::string& next : {connection(5, "/e", "p/E"), message(0, 1, "not whole")}) {
    EXPECT_EQ(read_ros1(chunks + next.substr(0, next.size() - 2)).notes, said);
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

TEST(Ros1Bag, ChunkThatHoldsMoreThanItSaysIsNoted) {
  const std::string inside = content(0);
  const std::string half = inside.substr(0, connection(0, "/a", "pkg/A").size());
  EXPECT_EQ(read_ros1(file_header() + chunk("none", half, inside)).notes,
            "chunk 0 holds " + std::to_string(inside.size()) + " bytes in whole records where " +
                std::to_string(half.size()) + " were announced: messages are lost\n");
}

TEST(Ros1Bag, AChunkNeedNotSayHowMuchItHolds) {
  const auto nameless = [](const std::string& inside) {
    return file_header() + record({op(5), "compression=none"}, inside);
  };
  const Ros1Outcome whole = read_ros1(nameless(content(0)));
  EXPECT_EQ(whole.messages.size(), 4U);
  EXPECT_EQ(whole.notes, "");
  const std::string cut = content(0).substr(0, content(0).size() - 50 - 2);
  EXPECT_EQ(read_ros1(nameless(cut)).notes, "chunk 0 ends within a record\n");
  const std::string file = nameless(content(0));
  EXPECT_EQ(read_ros1(file.substr(0, file.size() - 52)).notes,
            "the file is cut short; what is whole was read\n");
}

// What is left of its chunk is passed over, and not read as if it were none.
TEST(Ros1Bag, ARecordThatIsNoneEndsItsChunk) {
  const std::string good = chunk("none", content(4), content(4));
  const auto notes = [&good](const std::string& bad) {
    const std::string inside = content(0) + bad + message(0, 1, "no message any more");
    const Ros1Outcome outcome = read_ros1(file_header() + good + chunk("none", inside, inside));
    EXPECT_EQ(outcome.messages.size(), 8U);
    return outcome.notes;
  };
  const std::string damaged = "chunk 1 is damaged, read as far as it goes: ";
  EXPECT_EQ(notes(ros1_u32((1 << 20) + 1)), damaged + "a record's header of 1048577 bytes\n");
  EXPECT_EQ(notes(record({"conn=" + ros1_u32(0)}, "")),
            damaged + "a record's header has no 'op' of 1 bytes\n");
  for (const std::size_t bytes : {7U, 9U}) {
    const std::string time = "time=" + std::string(bytes, '\1');
    EXPECT_EQ(notes(record({op(2), "conn=" + ros1_u32(0), time}, "x")),
              damaged + "a record's header has no 'time' of 8 bytes\n");
  }
}

TEST(Ros1Bag, ARecordThatIsNoneOutsideOfChunksEndsTheReading) {
  const std::string bytes = file_header() + chunk("none", content(0), content(0));
  const Ros1Outcome outcome = read_ros1(bytes + record({"op=no"}, "") + connection(2, "/c", "p/C"));
  EXPECT_EQ(outcome.messages.size(), 4U);
  EXPECT_EQ(outcome.notes, "reading ends early: a record's header has no 'op' of 1 bytes\n");
}

TEST(Ros1Bag, AHeadersFieldWithoutAValueIsNone) {
  const std::string inside =
      connection(0, "/a", "pkg/A") +
      record({op(2), "conn", "conn=" + ros1_u32(0), "time=" + little(std::uint64_t{100})}, "data");
  EXPECT_EQ(read_ros1(file_header() + chunk("none", inside, inside)).messages,
            (std::vector<ReadMessage>{{"/a", "pkg/A", 100'000'000'000, "data"}}));
}

TEST(Ros1Bag, MessagesAndConnectionsMayLieOutsideOfChunks) {
  const std::string inside = message(1, 100, "inside");
  const std::string bytes = file_header() + connection(1, "/b", "pkg/B") +
                            message(1, 99, "before") + chunk("none", inside, inside);
  const Ros1Outcome outcome = read_ros1(bytes);
  ASSERT_EQ(outcome.messages.size(), 2U);
  EXPECT_EQ(outcome.messages[0], (ReadMessage{"/b", "pkg/B", 99'000'000'007, "before"}));
  EXPECT_EQ(outcome.messages[1], (ReadMessage{"/b", "pkg/B", 100'000'000'007, "inside"}));
}

TEST(Ros1Bag, AChunkWithinAChunkIsPassedOver) {
  const std::string inner = message(0, 1, "not to be read");
  const std::string inside = content(0) + chunk("none", inner, inner) + message(0, 104, "more");
  const Ros1Outcome outcome = read_ros1(file_header() + chunk("none", inside, inside));
  ASSERT_EQ(outcome.messages.size(), 5U);
  EXPECT_EQ(outcome.messages.back().data, "more");
  EXPECT_EQ(outcome.notes, "");
}

TEST(Ros1Bag, MessagesOfAConnectionThatIsNotThereAreNoted) {
  const std::string inside = content(0) + message(7, 104, "whose?") + message(7, 105, "whose?");
  const Ros1Outcome outcome = read_ros1(file_header() + chunk("none", inside, inside));
  EXPECT_EQ(outcome.messages.size(), 4U);
  EXPECT_EQ(outcome.notes, "messages of a connection that was not announced are passed over\n");
}

TEST(Ros1Bag, ConnectionsBeyondTheirLimitsArePassedOver) {
  const std::string large = record({op(7), "conn=" + ros1_u32(9), "topic=/large"},
                                   sized("type=p/T") + sized(std::string(16 << 20, ' ')));
  EXPECT_EQ(read_ros1(file_header() + large + message(9, 1, "x")).notes,
            "messages of a connection that was not announced are passed over\n");
  std::string many = file_header();
  for (std::uint32_t id = 0; id <= 65'536; ++id) many += connection(id, "/t", "p/T");
  const Ros1Outcome outcome = read_ros1(many + message(65'535, 1, "x") + message(65'536, 1, "x"));
  EXPECT_EQ(outcome.messages.size(), 1U);
}

TEST(Ros1Bag, TopicsAreAnnouncedAsTheirFirstConnectionHasThem) {
  const std::string name = "/" + std::string(5000, 'n');
  const std::string data = sized("type=sensor_msgs/msg/PointCloud2") + sized("md5sum=1158d4") +
                           sized("message_definition=uint32 height") + sized("latching=1");
  const std::string bytes = file_header() +
                            record({op(7), "conn=" + ros1_u32(0), "topic=" + name}, data) +
                            connection(0, "/another", "pkg/B") + connection(1, "/b", "pkg/B") +
                            message(0, 1, "a") + message(1, 1, "b");
  const auto source = read_ros1_bag(std::make_unique<MemoryStream>(test::bytes_of(bytes)));
  source->want("/b");
  EXPECT_EQ(source->progress(), 0.0);
  EXPECT_EQ(test::read_all_messages(*source),
            (std::vector<ReadMessage>{{"/b", "pkg/B", 1'000'000'007, "b"}}));
  EXPECT_EQ(source->progress(), 1.0);
  EXPECT_EQ(source->met(), 2U);
  ASSERT_EQ(source->announced().size(), 2U);
  const Topic& first = source->announced().front();
  EXPECT_EQ(first.name, name.substr(0, kMostNameBytes));
  EXPECT_EQ(first.type, "sensor_msgs/PointCloud2");
  EXPECT_EQ(first.definition->text, "uint32 height");
  EXPECT_EQ(first.definition->language, "ros1msg");
  EXPECT_EQ(first.definition->md5, "1158d4");
  EXPECT_TRUE(first.definition->latched);
  EXPECT_FALSE(source->announced().back().definition->latched);
}

TEST(Ros1Bag, MessageThatIsAllCompressionIsPassedOverByName) {
  const std::string inside = connection(0, "/a", "pkg/A") +
                             message(0, 1, std::string(70 << 20, '\0')) + message(0, 2, "next");
  const Ros1Outcome outcome =
      read_ros1(file_header() + chunk("lz4", inside, compress(Compression::lz4, inside)));
  ASSERT_EQ(outcome.messages.size(), 1U);
  EXPECT_EQ(outcome.messages[0].data, "next");
  EXPECT_EQ(outcome.notes,
            "a message of /a is passed over: it is more than 32 times as large as what it is "
            "compressed into\n");
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
