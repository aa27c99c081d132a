// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Animations, taken apart chunk by chunk and played by an independent reader.
#include "report/animated_png.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include <array>
#include <fstream>
#include <sstream>

#include "support/scratch.hpp"

namespace surefoot::report::test {
namespace {

constexpr int kWidth = 7;
constexpr int kHeight = 5;
constexpr std::uint32_t kWhite = 0xffffffff;

struct Chunk {
  std::string type;
  std::string data;
};

std::uint32_t big(const std::string& bytes, std::size_t at, std::size_t size) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < size; ++i) {
    value = (value << 8) | static_cast<unsigned char>(bytes.at(at + i));
  }
  return value;
}

std::vector<Chunk> chunks_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(file)), {});
  EXPECT_EQ(bytes.substr(0, 8), "\x89PNG\r\n\x1a\n");
  std::vector<Chunk> chunks;
  for (std::size_t at = 8; at < bytes.size();) {
    const std::uint32_t length = big(bytes, at, 4);
    chunks.push_back({bytes.substr(at + 4, 4), bytes.substr(at + 8, length)});
    const std::string checked = chunks.back().type + chunks.back().data;
    EXPECT_EQ(big(bytes, at + 8 + length, 4),
              crc32(0, reinterpret_cast<const Bytef*>(checked.data()),
                    static_cast<uInt>(checked.size())));
    at += 12 + length;
  }
  return chunks;
}

/// Lays a frame's pixels over the screen, as the specification says.
void play(const std::string& place, const std::string& pixels, std::vector<std::uint32_t>& screen) {
  const auto width = big(place, 4, 4), height = big(place, 8, 4);
  const auto left = big(place, 12, 4), top = big(place, 16, 4);
  ASSERT_LE(left + width, static_cast<std::uint32_t>(kWidth));
  ASSERT_LE(top + height, static_cast<std::uint32_t>(kHeight));
  std::string rows((4 * width + 1) * height, '\0');
  uLongf size = rows.size();
  ASSERT_EQ(uncompress(reinterpret_cast<Bytef*>(rows.data()), &size,
                       reinterpret_cast<const Bytef*>(pixels.data()), pixels.size()),
            Z_OK);
  ASSERT_EQ(size, rows.size());
  for (std::uint32_t y = 0; y < height; ++y) {
    const std::size_t row = y * (4 * width + 1);
    ASSERT_EQ(rows[row], '\0');
    for (std::uint32_t x = 0; x < width; ++x) {
      const std::uint32_t rgba = big(rows, row + 1 + 4 * x, 4);
      if ((rgba & 0xffU) == 0) continue;
      screen[(top + y) * kWidth + left + x] = (rgba >> 8) | 0xff000000U;
    }
  }
}

using AnimatedPngTest = surefoot::test::Scratch;

TEST_F(AnimatedPngTest, PlaysTheFramesThatWereAdded) {
  std::vector<Raster> frames(4, {kWidth, kHeight, std::vector<std::uint32_t>(35, kWhite)});
  frames[1].argb[9] = 0xff102030;   // one pixel
  frames[1].argb[33] = 0xff000000;  // and one far from it
  frames[2] = frames[1];            // nothing
  frames[3].argb[0] = 0xffff0000;   // back to white, but for one
  AnimatedPng animation(kWidth, kHeight);
  for (const Raster& frame : frames) animation.add(frame, 40);
  EXPECT_EQ(animation.frame_count(), 4U);
  const auto path = folder_ / "film.png";
  animation.save(path);
  const std::vector<Chunk> chunks = chunks_of(path);

  ASSERT_EQ(chunks.size(), 4U + 2U * 4U);
  EXPECT_EQ(chunks[0].type, "IHDR");
  EXPECT_EQ(big(chunks[0].data, 0, 4), 7U);
  EXPECT_EQ(big(chunks[0].data, 4, 4), 5U);
  EXPECT_EQ(chunks[1].type, "acTL");
  EXPECT_EQ(big(chunks[1].data, 0, 4), 4U);
  EXPECT_EQ(chunks[chunks.size() - 2].type, "tEXt");  // by which it is known for ours
  EXPECT_EQ(chunks.back().type, "IEND");
  std::vector<std::uint32_t> screen(35, 0);
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const Chunk& place = chunks[2 + 2 * i];
    const Chunk& pixels = chunks[3 + 2 * i];
    ASSERT_EQ(place.type, "fcTL");
    EXPECT_EQ(big(place.data, 0, 4), number++);
    EXPECT_EQ(big(place.data, 20, 2), 40U);
    EXPECT_EQ(big(place.data, 22, 2), 1000U);
    ASSERT_EQ(pixels.type, i == 0 ? "IDAT" : "fdAT");
    if (i > 0) {
      EXPECT_EQ(big(pixels.data, 0, 4), number++);
    }
    play(place.data, pixels.data.substr(i == 0 ? 0 : 4), screen);
    EXPECT_EQ(screen, frames[i].argb) << "frame " << i;
  }
}

TEST_F(AnimatedPngTest, RefusesAFrameOfAnotherSizeAndAPlaceThatCannotBeWritten) {
  AnimatedPng animation(kWidth, kHeight);
  EXPECT_THROW(animation.add({kHeight, kWidth, std::vector<std::uint32_t>(35)}, 40),
               std::invalid_argument);
  EXPECT_THROW(animation.add({kWidth, kHeight, std::vector<std::uint32_t>(34)}, 40),
               std::invalid_argument);
  animation.add({kWidth, kHeight, std::vector<std::uint32_t>(35, kWhite)}, 40);
  try {
    animation.save("/nowhere/at/all.png");
    ADD_FAILURE() << "is written";
  } catch (const std::runtime_error& error) {
    const std::string said = error.what();
    EXPECT_NE(said.find("/nowhere/at/all.png"), std::string::npos) << said;
    EXPECT_NE(said.find("No such file"), std::string::npos) << said;
  }
}

TEST_F(AnimatedPngTest, WhatIsThereStaysUntilTheNewOneIsWhole) {
  namespace fs = std::filesystem;
  const auto content = [](const fs::path& path) {
    std::ifstream file(path);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  AnimatedPng animation(kWidth, kHeight);
  animation.add({kWidth, kHeight, std::vector<std::uint32_t>(35, kWhite)}, 40);
  const fs::path path = folder_ / "film.png";
  std::ofstream(path) << "old";
  fs::create_hard_link(path, folder_ / "old.png");  // a rename leaves what it leads to
  std::ofstream(folder_ / "film.png.part") << "somebody's";
  animation.save(path);
  EXPECT_EQ(content(path).substr(0, 4), "\x89PNG");
  EXPECT_EQ(content(folder_ / "old.png"), "old");
  EXPECT_EQ(content(folder_ / "film.png.part"), "somebody's");
}

}  // namespace
}  // namespace surefoot::report::test
