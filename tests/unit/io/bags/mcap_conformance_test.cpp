// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The public conformance set of MCAP: every case as JSON, and beside it the file, or what Git LFS
// has in its place (its size and SHA-256). SUREFOOT_MCAP_CONFORMANCE names the folder "data" of
// foxglove/mcap, tests/conformance; without it the test is skipped.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>

#include "io/bags/mcap_reader.hpp"
#include "io/bags/mcap_writer.hpp"
#include "unit/io/bags/support.hpp"

namespace surefoot::io {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Fields = std::map<std::string, Json>;

std::uint64_t number(const Json& value) { return std::stoull(value.get<std::string>()); }

std::string bytes_of_values(const Json& values) {
  std::string bytes;
  for (const Json& value : values) bytes += static_cast<char>(number(value));
  return bytes;
}

McapWriter::Metadata map_of(const Json& values) {
  McapWriter::Metadata map;
  for (const auto& [key, value] : values.items()) map.emplace_back(key, value.get<std::string>());
  return map;
}

McapOptions options_of(const Json& test, const Fields& header) {
  const auto listed = test["meta"]["variant"]["features"].get<std::set<std::string>>();
  const auto has = [&listed](const char* feature) { return listed.count(feature) > 0; };
  McapOptions options;
  options.profile = header.at("profile").get<std::string>();
  options.library = header.at("library").get<std::string>();
  options.compression = Compression::none;
  options.chunks = has("ch");
  options.message_index = has("mx");
  options.chunk_index = has("chx");
  options.attachment_index = has("ax");
  options.metadata_index = has("mdx");
  options.statistics = has("st");
  options.repeated_schemas = has("rsh");
  options.repeated_channels = has("rch");
  options.summary_offsets = has("sum");
  if (has("pad")) options.record_tail = "\x01\xff\xff";
  return options;
}

// Writes the records of the data section; the writer makes the rest.
void write_case(const Json& test, const fs::path& file) {
  std::unique_ptr<McapWriter> writer;
  for (const Json& record : test["records"]) {
    Fields f;
    for (const Json& field : record["fields"]) f[field[0].get<std::string>()] = field[1];
    const auto type = record["type"].get<std::string>();
    if (type == "Header") writer = std::make_unique<McapWriter>(file, options_of(test, f));
    if (type == "DataEnd") break;
    if (type == "Schema") {
      writer->add_schema(f["name"].get<std::string>(), f["encoding"].get<std::string>(),
                         bytes_of_values(f["data"]));
    } else if (type == "Channel") {
      writer->add_channel(static_cast<std::uint16_t>(number(f["schema_id"])),
                          f["topic"].get<std::string>(), f["message_encoding"].get<std::string>(),
                          map_of(f["metadata"]));
    } else if (type == "Message") {
      writer->write(static_cast<std::uint16_t>(number(f["channel_id"])),
                    static_cast<std::uint32_t>(number(f["sequence"])), number(f["log_time"]),
                    number(f["publish_time"]), bytes_of_values(f["data"]));
    } else if (type == "Attachment") {
      writer->attach(number(f["log_time"]), number(f["create_time"]), f["name"].get<std::string>(),
                     f["media_type"].get<std::string>(), bytes_of_values(f["data"]));
    } else if (type == "Metadata") {
      writer->add_metadata(f["name"].get<std::string>(), map_of(f["metadata"]));
    }
  }
  writer->finish();
}

std::vector<std::string> messages_of(const Json& test) {
  std::vector<std::string> data;
  for (const Json& record : test["records"]) {
    if (record["type"] != "Message") continue;
    for (const Json& field : record["fields"]) {
      if (field[0] == "data") data.push_back(bytes_of_values(field[1]));
    }
  }
  return data;
}

std::string sha256_of(const fs::path& file) {
  std::FILE* const pipe = popen(("sha256sum '" + file.string() + "'").c_str(), "r");
  char text[65] = {};
  const std::size_t got = pipe == nullptr ? 0 : std::fread(text, 1, 64, pipe);
  if (pipe != nullptr) pclose(pipe);
  return {text, got};
}

// The file's bytes are as expected: those themselves, or by what LFS says of them.
void expect_file(const fs::path& written, const fs::path& expected) {
  const std::string reference = test::content_of(expected);
  const std::size_t at = reference.find("sha256:");
  if (reference.starts_with("version https://git-lfs")) {
    EXPECT_EQ(sha256_of(written), reference.substr(at + 7, 64)) << expected;
  } else {
    EXPECT_EQ(test::content_of(written), reference) << expected;
  }
}

TEST(McapConformance, WrittenByteForByteAndReadBack) {
  const char* const folder = std::getenv("SUREFOOT_MCAP_CONFORMANCE");
  if (folder == nullptr) GTEST_SKIP() << "SUREFOOT_MCAP_CONFORMANCE names no folder";
  const test::TemporaryFolder scratch;
  const fs::path file = scratch.path() / "written.mcap";
  int cases = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".json") continue;
    const Json test = Json::parse(test::content_of(entry.path()));
    write_case(test, file);
    fs::path expected = entry.path();
    expect_file(file, expected.replace_extension(".mcap"));
    const auto source = read_mcap(std::make_unique<FileStream>(file));
    std::vector<std::string> data;
    for (const test::ReadMessage& message : test::read_all_messages(*source)) {
      data.push_back(message.data);
    }
    EXPECT_EQ(data, messages_of(test)) << entry.path();
    EXPECT_TRUE(source->notes().empty()) << entry.path() << test::joined(source->notes());
    ++cases;
  }
  std::printf("%d cases\n", cases);
  EXPECT_GT(cases, 0);
}

}  // namespace
}  // namespace surefoot::io
