// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/map_export.hpp"

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/file_reader.hpp"
#include "io/files/ply_reader.hpp"
#include "mapping/submap.hpp"
#include "runs/saved_map.hpp"
#include "support/scratch.hpp"

namespace surefoot::runs {
namespace {

class MapExportTest : public test::Scratch {
 protected:
  /// Pieces of `points`, far apart from each other; nothing joins them.
  void write(const std::vector<int>& points, double x) {
    mapping::SavedMap map;
    for (const int count : points) {
      mapping::Piece piece;
      piece.T_world_piece.translation.x() = x;
      piece.restarted = !map.pieces.empty();
      piece.eyes = {{0.0F, 0.0F, 0.0F}};
      for (int i = 0; i < count; ++i) {
        piece.points.emplace_back(5.0F, static_cast<float>(i), 0.0F);
        piece.seen_from.push_back(0);
      }
      map.pieces.push_back(piece);
      map.places.push_back(describe_place(make_submap(piece)));
    }
    write_saved_map(folder_ / "map.surefoot", map);
  }
  [[nodiscard]] std::vector<std::string> notes_of(const MapExport& wanted) const {
    return export_map(folder_ / "map.surefoot", wanted).notes;
  }
  [[nodiscard]] std::size_t points_of(const std::string& file) const {
    std::vector<std::byte> bytes;
    io::read_whole_file(folder_ / file, bytes);
    return io::parse_ply(bytes).size;
  }
};

TEST_F(MapExportTest, FramesOverEachOtherAreToldAndWrittenOneByOne) {
  write({10, 20}, 0.0);
  MapExport wanted;
  wanted.ply = folder_ / "all.ply";
  const std::vector<std::string> notes = notes_of(wanted);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_NE(notes[0].find("2 frames that nothing joins"), std::string::npos) << notes[0];
  EXPECT_EQ(points_of("all.ply"), 30U);
  wanted.ply = folder_ / "second.ply";
  wanted.frame = 1;
  EXPECT_TRUE(notes_of(wanted).empty());
  EXPECT_EQ(points_of("second.ply"), 20U);
  wanted.ply = folder_ / "third.ply";
  wanted.frame = 2;
  EXPECT_THROW((void)notes_of(wanted), std::invalid_argument);
  write({10}, 0.0);
  wanted.frame.reset();
  EXPECT_TRUE(notes_of(wanted).empty());
}

TEST_F(MapExportTest, FloatsFarFromTheOriginAreTold) {
  write({10}, 5'400'000.0);
  MapExport wanted;
  wanted.las = folder_ / "map.las";
  EXPECT_TRUE(notes_of(wanted).empty());
  wanted.overwrite = true;
  wanted.pcd = folder_ / "map.pcd";
  const std::vector<std::string> notes = notes_of(wanted);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_NE(notes[0].find("5400 km"), std::string::npos) << notes[0];
  EXPECT_NE(notes[0].find("0.5 m apart"), std::string::npos) << notes[0];
}

}  // namespace
}  // namespace surefoot::runs
