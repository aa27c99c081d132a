// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "io/bags/compression.hpp"
#include "io/bags/mcap_reader.hpp"
#include "io/bags/mcap_writer.hpp"
#include "io/recording.hpp"
#include "sensors/bytes.hpp"
#include "unit/io/bags/support.hpp"

namespace surefoot::io {
namespace {

using test::little;
using test::ReadMessage;

constexpr int kMessages = 12;

std::string data_of(int i) {
  return std::string(static_cast<std::size_t>(100 + i), static_cast<char>('a' + i));
}

ReadMessage expected(int i) {
  return {i % 2 == 0 ? "/even" : "/odd", "pkg/Type", 1000 + i, data_of(i)};
}

std::string file_with(const McapOptions& options) {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "a.mcap";
  McapWriter writer(file, options);
  const std::uint16_t schema = writer.add_schema("pkg/msg/Type", "ros2msg", "int32 a\n");
  const std::uint16_t even = writer.add_channel(schema, "/even", "cdr");
  const std::uint16_t odd = writer.add_channel(schema, "/odd", "cdr", {{"k", "v"}});
  for (int i = 0; i < kMessages; ++i) {
    const auto time = static_cast<std::uint64_t>(1000 + i);
    writer.write(i % 2 == 0 ? even : odd, static_cast<std::uint32_t>(i), time, time, data_of(i));
  }
  writer.attach(1, 2, "notes.txt", "text/plain", "hello");
  writer.add_metadata("about", {{"robot", "dog"}});
  writer.finish();
  return test::content_of(file);
}

McapOptions small_chunks(Compression compression) {
  McapOptions options;
  options.compression = compression;
  options.chunk_bytes = 400;
  return options;
}

struct Outcome {
  std::vector<ReadMessage> messages;
  std::string notes;
};
Outcome read_bytes(const std::string& bytes, const std::string& topic = {}) {
  const auto source = read_mcap(std::make_unique<MemoryStream>(test::bytes_of(bytes)));
  source->want(topic);
  Outcome outcome{test::read_all_messages(*source), {}};
  outcome.notes = test::joined(source->notes());
  return outcome;
}

std::vector<McapOptions> flavours() {
  std::vector<McapOptions> all;
  for (const Compression compression : {Compression::none, Compression::lz4, Compression::zstd}) {
    all.push_back(small_chunks(compression));
  }
  McapOptions bare;  // no chunk, no index, no summary
  bare.chunks = bare.message_index = bare.chunk_index = bare.attachment_index = false;
  bare.metadata_index = bare.statistics = bare.repeated_schemas = bare.repeated_channels = false;
  bare.summary_offsets = false;
  all.push_back(bare);
  McapOptions tail = small_chunks(Compression::lz4);  // bytes that readers do not know
  tail.record_tail = "xyz";
  all.push_back(tail);
  return all;
}

TEST(Mcap, WhatIsWrittenIsReadBack) {
  for (const McapOptions& options : flavours()) {
    const Outcome outcome = read_bytes(file_with(options));
    ASSERT_EQ(outcome.messages.size(), kMessages);
    for (int i = 0; i < kMessages; ++i) {
      EXPECT_EQ(outcome.messages[static_cast<std::size_t>(i)], expected(i));
    }
    EXPECT_EQ(outcome.notes, "");
  }
}

TEST(Mcap, OneTopicAlone) {
  const Outcome outcome = read_bytes(file_with(small_chunks(Compression::zstd)), "/odd");
  ASSERT_EQ(outcome.messages.size(), kMessages / 2);
  EXPECT_EQ(outcome.messages[0], expected(1));
}

// Wherever a file is cut, every message that is whole before the cut is there, and nothing else.
TEST(Mcap, CutAnywhere) {
  for (const McapOptions& options : flavours()) {
    const std::string whole = file_with(options);
    std::size_t before = 0;
    for (std::size_t size = mcap::kMagic.size(); size < whole.size(); ++size) {
      const Outcome outcome = read_bytes(whole.substr(0, size));
      ASSERT_GE(outcome.messages.size(), before) << size;
      before = outcome.messages.size();
      for (std::size_t i = 0; i < before; ++i) {
        ASSERT_EQ(outcome.messages[i], expected(static_cast<int>(i))) << size;
      }
    }
    EXPECT_EQ(before, kMessages);
  }
}

TEST(Mcap, CutIsSaid) {
  const std::string whole = file_with(small_chunks(Compression::none));
  EXPECT_NE(read_bytes(whole.substr(0, 300)).notes.find("cut short"), std::string::npos);
}

// As a recorder leaves it that was stopped: the chunk's lengths and checksum were to be filled in.
TEST(Mcap, ChunkThatWasNeverClosed) {
  for (const Compression compression : {Compression::none, Compression::zstd}) {
    McapOptions options;
    options.compression = compression;
    std::string bytes = file_with(options);
    const std::size_t chunk =
        mcap::kMagic.size() + 9 + 4 + options.profile.size() + 4 + options.library.size();
    ASSERT_EQ(bytes[chunk], '\x06');
    const std::size_t content =
        chunk + 9 + 8 + 8 + 8 + 4 + 4 + (compression == Compression::zstd ? 4 : 0);
    const auto size = load<std::uint64_t>(test::bytes_of(bytes).data() + content, false);
    bytes.resize(content + 8 + size);
    const std::string open(8, '\xff');
    bytes.replace(chunk + 1, 8, open);
    bytes.replace(content, 8, open);
    const Outcome outcome = read_bytes(bytes);
    EXPECT_EQ(outcome.messages.size(), kMessages);
    EXPECT_NE(outcome.notes.find("cut short"), std::string::npos) << outcome.notes;
  }
}

// Where the n-th chunk's record begins.
std::size_t chunk_at(const std::string& bytes, int n) {
  std::size_t at = mcap::kMagic.size();
  while (bytes[at] != '\x06' || n-- > 0) {
    at += 9 + load<std::uint64_t>(test::bytes_of(bytes).data() + at + 1, false);
  }
  return at;
}

// Not the first one: it holds the channels.
TEST(Mcap, DamagedChunkIsNotedAndTheNextOneRead) {
  for (const Compression compression : {Compression::none, Compression::lz4, Compression::zstd}) {
    std::string bytes = file_with(small_chunks(compression));
    bytes[chunk_at(bytes, 1) + 80] ^= '\x55';
    const Outcome outcome = read_bytes(bytes);
    EXPECT_NE(outcome.notes.find("chunk 1"), std::string::npos) << outcome.notes;
    ASSERT_GE(outcome.messages.size(), 6U);
    EXPECT_EQ(outcome.messages.front(), expected(0));
    EXPECT_EQ(outcome.messages.back(), expected(kMessages - 1));
  }
}

// A length within a chunk that promises more than the chunk holds, where no checksum tells.
TEST(Mcap, MessageThatClaimsMoreThanItsChunkHoldsIsNoted) {
  for (const std::string topic : {"", "/even", "/odd"}) {
    std::string bytes = file_with(small_chunks(Compression::none));
    const std::size_t chunk = chunk_at(bytes, 1);
    bytes.replace(chunk + 9 + 24, 4, little(0U));  // no checksum
    const std::size_t content = chunk + 9 + 8 + 8 + 8 + 4 + 4 + 8;
    ASSERT_EQ(bytes[content], '\x05');
    bytes.replace(content + 1, 8, little(std::uint64_t{100'000'000}));
    const Outcome outcome = read_bytes(bytes, topic);
    EXPECT_NE(outcome.notes.find("chunk 1 is damaged, read as far as it goes: a message of "
                                 "100000000 bytes"),
              std::string::npos)
        << outcome.notes;
  }
}

TEST(Mcap, ChunkThatHoldsLessThanItSaysIsNoted) {
  for (const Compression compression : {Compression::none, Compression::lz4, Compression::zstd}) {
    std::string bytes = file_with(small_chunks(compression));
    const std::size_t size = chunk_at(bytes, 1) + 9 + 16;
    bytes.replace(size, 8, little(std::uint64_t{12'345}));
    const std::string notes = read_bytes(bytes).notes;
    EXPECT_NE(notes.find("where 12345 were announced"), std::string::npos) << notes;
  }
}

TEST(Mcap, AnotherFileBehindTheEndIsNoted) {
  const std::string bytes = file_with(small_chunks(Compression::zstd));
  const Outcome outcome = read_bytes(bytes + bytes);
  EXPECT_EQ(outcome.messages.size(), kMessages);
  EXPECT_NE(outcome.notes.find("goes on after its end"), std::string::npos) << outcome.notes;
}

// 100 MB of zeros, which Zstandard makes 10 kB of.
TEST(Mcap, MessageThatIsAllCompressionIsPassedOverByName) {
  const test::TemporaryFolder folder;
  const std::string zeros(100'000'000, '\0');
  for (const bool one_by_one : {false, true}) {
    const std::filesystem::path file = folder.path() / (one_by_one ? "a.mcap" : "b.mcap");
    McapOptions options;
    options.compression = one_by_one ? Compression::none : Compression::zstd;
    McapWriter writer(file, options);
    const std::uint16_t schema = writer.add_schema("pkg/msg/Type", "ros2msg", "int32 a\n");
    const std::uint16_t channel = writer.add_channel(schema, "/zeros", "cdr");
    writer.write(channel, 0, 1, 1, one_by_one ? compress(Compression::zstd, zeros) : zeros);
    writer.write(channel, 1, 2, 2, "good");
    writer.finish();
    const Outcome outcome = read_bytes(test::content_of(file));
    ASSERT_EQ(outcome.messages.size(), 1U);
    EXPECT_EQ(outcome.messages[0].data, "good");
    EXPECT_NE(outcome.notes.find("a message of /zeros is passed over: it is more than 32 times"),
              std::string::npos)
        << outcome.notes;
  }
}

TEST(Mcap, ChecksumOfTheData) {
  McapOptions options;
  options.chunks = false;
  std::string bytes = file_with(options);
  bytes[bytes.find("aaaa")] = 'A';
  EXPECT_NE(read_bytes(bytes).notes.find("checksum of the whole data"), std::string::npos);
}

TEST(Mcap, UnknownRecordsArePassedOver) {
  std::string bytes = file_with(small_chunks(Compression::none));
  const std::string unknown = "\x91" + little(std::uint64_t{5}) + "hello";
  bytes.insert(bytes.find('\x06', 30), unknown);
  EXPECT_EQ(read_bytes(bytes).messages.size(), kMessages);
}

TEST(Mcap, LengthsThatLieTakeNoMemory) {
  McapOptions options;
  options.chunks = false;
  const std::string good = file_with(options);
  for (std::size_t at = mcap::kMagic.size(); at + 9 < good.size(); ++at) {
    std::string bad = good;
    bad.replace(at, 8, little(std::uint64_t{1} << 40));
    EXPECT_LE(read_bytes(bad).messages.size(), kMessages);
  }
}

/// A file of small chunks, and where the first one's two lengths stand.
struct ChunkLengths {
  std::string bytes;
  std::size_t record = 0;
  std::size_t content = 0;
  [[nodiscard]] Outcome with(std::size_t at, std::uint64_t lie) const {
    std::string lying = bytes;
    lying.replace(at, 8, little(lie));
    return read_bytes(lying);
  }
  [[nodiscard]] std::uint64_t at(std::size_t place) const {
    return load<std::uint64_t>(test::bytes_of(bytes).data() + place, false);
  }
};

ChunkLengths chunk_lengths(Compression compression) {
  ChunkLengths chunk{file_with(small_chunks(compression)), 0, 0};
  const std::size_t begin = chunk.bytes.find('\x06', mcap::kMagic.size() + 9);
  chunk.record = begin + 1;
  const std::size_t name = begin + 9 + 28;  // behind times, size and checksum
  chunk.content = name + 4 + load<std::uint32_t>(test::bytes_of(chunk.bytes).data() + name, false);
  return chunk;
}

constexpr Compression kChunkCompressions[] = {Compression::none, Compression::lz4,
                                              Compression::zstd};

// The lengths of chunks are the ones where a byte that is wrong may cost all that follows.
TEST(Mcap, AChunkWhoseRecordsLengthLiesCostsNothing) {
  for (const Compression compression : kChunkCompressions) {
    const ChunkLengths chunk = chunk_lengths(compression);
    const std::uint64_t length = chunk.at(chunk.record);
    ASSERT_LT(length, 1000U);  // a chunk it is
    constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
    for (const std::uint64_t lie :
         {length - 60, length - 1, length + 1, length + 40, length + 256, length + 4096,
          length + 65536, length + (std::uint64_t{1} << 40), kMost}) {
      const Outcome outcome = chunk.with(chunk.record, lie);
      ASSERT_EQ(outcome.messages.size(), kMessages) << length << ' ' << lie << outcome.notes;
      EXPECT_NE(outcome.notes.find("the record of chunk 0 has "), std::string::npos);
    }
  }
}

TEST(Mcap, AChunkWhoseContentsLengthLiesCostsNothing) {
  for (const Compression compression : kChunkCompressions) {
    const ChunkLengths chunk = chunk_lengths(compression);
    const std::uint64_t length = chunk.at(chunk.content);
    ASSERT_LT(length, chunk.at(chunk.record));
    constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
    for (const std::uint64_t lie : {std::uint64_t{0}, length / 2, length - 1, length + 1,
                                    length + 300, length + (std::uint64_t{1} << 40), kMost}) {
      const Outcome outcome = chunk.with(chunk.content, lie);
      ASSERT_EQ(outcome.messages.size(), kMessages) << length << ' ' << lie << outcome.notes;
    }
  }
}

TEST(Mcap, SomethingElseIsRefused) {
  EXPECT_THROW((void)read_bytes("#ROSBAG V2.0\n and so on"), ReadError);
  EXPECT_THROW((void)read_bytes(""), ReadError);
}

// rosbag2 does so, and only its metadata.yaml tells.
TEST(Mcap, MessagesThatAreCompressedOneByOne) {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "a.mcap";
  const std::string large(100'000, 'z');
  const std::string compressed = compress(Compression::zstd, large);
  std::string damaged = compressed;
  damaged[6] ^= '\x7f';
  McapWriter writer(file, {});
  const std::uint16_t schema = writer.add_schema("pkg/msg/Type", "ros2msg", "int32 a\n");
  const std::uint16_t cdr = writer.add_channel(schema, "/cdr", "cdr");
  const std::uint16_t other = writer.add_channel(schema, "/other", "ros1");
  writer.write(cdr, 0, 1, 1, compressed);
  writer.write(cdr, 1, 2, 2, damaged);
  writer.write(cdr, 2, 3, 3, "plain");
  writer.write(other, 3, 4, 4, compressed);
  writer.finish();
  const Outcome outcome = read_bytes(test::content_of(file));
  ASSERT_EQ(outcome.messages.size(), 3U);
  EXPECT_EQ(outcome.messages[0].data, large);
  EXPECT_EQ(outcome.messages[1].data, "plain");
  EXPECT_EQ(outcome.messages[2].data, compressed);  // not CDR: it may begin as it likes
  EXPECT_NE(outcome.notes.find("a message of /cdr is passed over"), std::string::npos);
}

TEST(Mcap, MessagesOfAChannelWithoutSchemaAndOfNoChannel) {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "a.mcap";
  McapWriter writer(file, {});
  const std::uint16_t channel = writer.add_channel(0, "/bare", "json");
  writer.write(channel, 0, 1, 1, "{}");
  writer.write(99, 0, 2, 2, "lost");
  writer.finish();
  const Outcome outcome = read_bytes(test::content_of(file));
  ASSERT_EQ(outcome.messages.size(), 1U);
  EXPECT_EQ(outcome.messages[0], (ReadMessage{"/bare", "", 1, "{}"}));
  EXPECT_NE(outcome.notes.find("not announced"), std::string::npos);
}

}  // namespace
}  // namespace surefoot::io
