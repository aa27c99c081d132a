// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot map, export, and run --localize: a map that is made, written as other programs read it,
// and found again.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <sstream>
#include <string>

#include "io/trajectory_files.hpp"
#include "process.hpp"

namespace surefoot::test {
namespace {

namespace fs = std::filesystem;

/// The recording "in" and its map in "map", made once for all tests.
class MapCommand : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    scratch_ = std::make_unique<ScratchFolder>();
    const ProcessResult simulated = surefoot({"simulate", "campus", "--scans", "60", "--speed",
                                              "2.4", "--format", "pcap", "-q", "-o", "in"});
    if (simulated.exit_code != 0) return;  // built without the simulation
    made_ = surefoot({"map", "in", "-o", "map", "--no-report", "--no-picture"});
  }
  static void TearDownTestSuite() { scratch_.reset(); }
  void SetUp() override {
    if (!fs::exists(path("in"))) GTEST_SKIP() << "built without the simulation";
    if (made_.errors.find("built without Ceres") != std::string::npos) GTEST_SKIP() << made_;
    ASSERT_EQ(made_.exit_code, 0) << made_;
  }
  [[nodiscard]] static fs::path path(const std::string& name) { return scratch_->path() / name; }
  [[nodiscard]] static ProcessResult surefoot(const std::vector<std::string>& arguments) {
    return run_surefoot(arguments, scratch_->path());
  }
  static void expect_refused(const std::vector<std::string>& arguments, const std::string& named) {
    const ProcessResult result = surefoot(arguments);
    EXPECT_EQ(result.exit_code, 2) << result;
    EXPECT_NE(result.errors.find(named), std::string::npos) << "not named: " << named << result;
  }

  static inline std::unique_ptr<ScratchFolder> scratch_;
  static inline ProcessResult made_;
};

TEST_F(MapCommand, LeavesTheMapBesideAnOdometryThatIsLeftAlone) {
  for (const char* file : {"trajectory_optimized.tum", "map_optimized.ply", "loops.csv",
                           "pose_graph.g2o", "map.surefoot"}) {
    EXPECT_TRUE(fs::exists(path("map") / file)) << file;
  }
  EXPECT_NE(made_.output.find("0 taken"), std::string::npos) << made_;  // it never came back
  const ProcessResult run =
      surefoot({"run", "in", "-o", "run", "--no-report", "--no-picture", "-q"});
  ASSERT_EQ(run.exit_code, 0) << run;
  EXPECT_EQ(file_content(path("run/trajectory.tum")), file_content(path("map/trajectory.tum")));
  EXPECT_EQ(file_content(path("run/map.ply")), file_content(path("map/map.ply")));
}

/// One that ends before the recording does tells nothing of its loops, and takes no map away.
TEST_F(MapCommand, IsMadeWithATruthOfAnotherTime) {
  Trajectory truth = io::read_tum(path("map/trajectory.tum"));
  truth.resize(truth.size() / 3);
  io::write_tum(path("begin.tum"), truth);
  const ProcessResult run = surefoot(
      {"map", "in", "-o", "judged", "--truth", "begin.tum", "--no-report", "--no-picture"});
  ASSERT_EQ(run.exit_code, 0) << run;
  EXPECT_NE(run.output.find("loops are not judged"), std::string::npos) << run;
  EXPECT_EQ(file_content(path("judged/loops.csv")), file_content(path("map/loops.csv")));
  EXPECT_TRUE(fs::exists(path("judged/map.surefoot")));
}

TEST_F(MapCommand, ItsRunYamlRepeatsIt) {
  Trajectory truth = io::read_tum(path("in/gt.tum"));
  for (StampedPose& pose : truth) pose.pose.translation *= 1.5;
  io::write_tum(path("stretched.tum"), truth);
  const ProcessResult first = surefoot({"map", "in", "-o", "first", "--truth", "stretched.tum",
                                        "--loop-candidates", "1", "--no-loops", "--no-report"});
  ASSERT_EQ(first.exit_code, 0) << first;
  const ProcessResult again = surefoot({"map", "--config", "first/run.yaml", "-o", "repeated"});
  ASSERT_EQ(again.exit_code, 0) << again;
  for (const std::string& told :
       {std::string("--loop-candidates=1"), std::string("--no-loops=true"),
        "--truth=" + path("stretched.tum").string()}) {
    EXPECT_NE(again.errors.find(told), std::string::npos) << told << again;
  }
  for (const char* file : {"picture.png", "loops.csv", "trajectory_optimized.tum"}) {
    EXPECT_FALSE(file_content(path("first") / file).empty()) << file;
    EXPECT_TRUE(file_content(path("first") / file) == file_content(path("repeated") / file))
        << file;
  }
  expect_refused({"run", "--config", "map/run.yaml", "-o", "none"}, "surefoot map --config");
}

TEST_F(MapCommand, IsWrittenAsOthersReadIt) {
  const ProcessResult result =
      surefoot({"export", "map", "--pcd", "all.pcd", "--ply", "all.ply", "--las", "all.las",
                "--grid", "grid.pgm", "--elevation", "ground.asc"});
  ASSERT_EQ(result.exit_code, 0) << result;
  EXPECT_EQ(file_content(path("grid.pgm")).substr(0, 3), "P5\n");
  EXPECT_NE(file_content(path("grid.yaml")).find("image: grid.pgm"), std::string::npos);
  EXPECT_EQ(file_content(path("ground.asc")).substr(0, 5), "ncols");
  EXPECT_TRUE(fs::exists(path("ground_variance.asc")));
  EXPECT_GT(fs::file_size(path("all.pcd")), 100'000U);
  EXPECT_EQ(file_content(path("all.ply")).substr(0, 3), "ply");
  EXPECT_EQ(file_content(path("all.las")).substr(0, 4), "LASF");
  EXPECT_GT(fs::file_size(path("all.las")), 100'000U);
  ASSERT_EQ(surefoot({"export", "map", "--grid", "lot #2.pgm"}).exit_code, 0);
  EXPECT_NE(file_content(path("lot #2.yaml")).find("image: \"lot #2.pgm\"\n"), std::string::npos);
  expect_refused({"export", "map"}, "nothing to write");
  const std::pair<const char*, const char*> lies[] = {
      {"--pcd", "expected .pcd"},
      {"--ply", "expected .ply"},
      {"--las", "expected .las"},
      {"--mesh", "expected .ply, .obj or .stl"},
      {"--elevation", "expected .asc, .tif or .tiff"}};
  for (const auto& [flag, why] : lies) {
    expect_refused({"export", "map", flag, "map.laz"}, why);
    EXPECT_FALSE(fs::exists(path("map.laz")));
  }
}

TEST_F(MapCommand, IsNotWrittenOverWhatIsThere) {
  write_content(path("kept.pcd"), "mine");
  write_content(path("heights_variance.asc"), "mine");
  expect_refused({"export", "map", "--ply", "new.ply", "--pcd", "kept.pcd"},
                 "kept.pcd: is there already");
  expect_refused({"export", "map", "--elevation", "heights.asc"}, "heights_variance.asc");
  expect_refused({"export", "map", "--ply", "one", "--las", "./one"}, "twice");
  write_content(path("kept.txt"), "mine");
  expect_refused({"export", "map", "--grid", "kept.txt", "--overwrite"}, "expected .pgm or .yaml");
  EXPECT_FALSE(fs::exists(path("new.ply")));
  EXPECT_EQ(file_content(path("kept.pcd")), "mine");
  const ProcessResult result = surefoot({"export", "map", "--pcd", "kept.pcd", "--overwrite"});
  EXPECT_EQ(result.exit_code, 0) << result;
  EXPECT_GT(fs::file_size(path("kept.pcd")), 100'000U);
}

TEST_F(MapCommand, IsNeverWrittenOverItselfNorWhatIsNoFile) {
  const std::string map = file_content(path("map/map.surefoot"));
  fs::create_directory(path("folder.ply"));
  // Not a real device: root's test of a program that is wrong would replace it.
  ASSERT_EQ(mkfifo(path("pipe.ply").c_str(), 0600), 0);
  fs::create_symlink(path("map/map.surefoot"), path("link.ply"));
  expect_refused({"export", "map", "--ply", "link.ply", "--overwrite"}, "the map itself");
  expect_refused({"export", "map", "--ply", "map/map.surefoot", "--overwrite"}, "expected .ply");
  expect_refused({"export", "map", "--ply", "pipe.ply", "--overwrite"}, "pipe.ply: is no file");
  expect_refused({"export", "map", "--ply", "folder.ply", "--overwrite"}, "is no file");
  EXPECT_TRUE(file_content(path("map/map.surefoot")) == map);
}

TEST_F(MapCommand, BecomesTilesInAFolderOfTheirOwn) {
  const ProcessResult result =
      surefoot({"export", "map", "--tiles", "tiles", "--tiles-at", "48.1", "11.6", "520", "90"});
  ASSERT_EQ(result.exit_code, 0) << result;
  EXPECT_NE(result.output.find(" points in "), std::string::npos) << result;
  EXPECT_NE(file_content(path("tiles/tileset.json")).find("\"1.1\""), std::string::npos);
  EXPECT_EQ(file_content(path("tiles/tiles/r.glb")).substr(0, 4), "glTF");
  write_content(path("no_folder"), "");
  for (const char* taken : {"tiles", "no_folder"}) {  // is said before any work
    expect_refused({"export", "map", "--tiles", taken, "--ply", "beside.ply", "--overwrite"},
                   taken + std::string(": is there already; tiles need a new or an empty folder"));
    EXPECT_FALSE(fs::exists(path("beside.ply")));
  }
  expect_refused({"export", "map", "--tiles", "one.ply", "--ply", "one.ply"}, "twice");
  expect_refused({"export", "map", "--tiles", "more", "--tiles-at", "91", "0", "0", "0"},
                 "--tiles-at");
  EXPECT_FALSE(fs::exists(path("more")));
}

/// Triangles as others read them; the simulator does, and walks on them.
TEST_F(MapCommand, BecomesASceneToWalkThrough) {
  for (const char* file : {"mesh.ply", "mesh.obj", "mesh.STL"}) {
    const ProcessResult result = surefoot({"export", "map", "--mesh", file, "--mesh-cell", "0.4"});
    ASSERT_EQ(result.exit_code, 0) << result;
    EXPECT_NE(result.output.find(" triangles"), std::string::npos) << result;
    EXPECT_GT(fs::file_size(path(file)), 100'000U) << file;
  }
  EXPECT_EQ((fs::file_size(path("mesh.STL")) - 84) % 50, 0U);
  write_content(path("way.txt"), "1 0 0\n6 0 0\n6 1 0\n1 1 0\n");
  for (const char* file : {"mesh.ply", "mesh.obj"}) {
    const ProcessResult result =
        surefoot({"simulate", file, "--route", "way.txt", "--scans", "2", "--format", "pcap", "-q",
                  "-o", file + std::string("-walk")});
    EXPECT_EQ(result.exit_code, 0) << result;
  }
  expect_refused({"export", "map", "--mesh", "mesh.dae"}, "mesh.dae: ends with '.dae'");
  expect_refused({"export", "map", "--mesh", "none.ply", "--mesh-cell", "0"}, "--mesh-cell");
}

TEST_F(MapCommand, HeightsAreLayersThatGdalReads) {
  const ProcessResult result = surefoot({"export", "map", "--elevation", "ground.tif",
                                         "--elevation-cell", "0.25", "--max-step", "0.1"});
  ASSERT_EQ(result.exit_code, 0) << result;
  EXPECT_EQ(file_content(path("ground.tif")).substr(0, 3), "II*");
  const ProcessResult capitals = surefoot(
      {"export", "map", "--elevation", "G.TIF", "--elevation-cell", "0.25", "--grid", "G.PGM"});
  ASSERT_EQ(capitals.exit_code, 0) << capitals;
  EXPECT_EQ(file_content(path("G.TIF")).substr(0, 3), "II*");
  EXPECT_EQ(file_content(path("G.PGM")).substr(0, 3), "P5\n");
  EXPECT_NE(file_content(path("G.yaml")).find("image: G.PGM"), std::string::npos);
  expect_refused({"export", "map", "--elevation", "ground.tif", "--max-slope", "nan"},
                 "--max-slope");
  const std::string info = path("info.txt").string();
  const std::string command = "gdalinfo -stats " + path("ground.tif").string() + " > " + info;
  if (std::system("command -v gdalinfo > /dev/null") != 0) GTEST_SKIP() << "no gdalinfo here";
  ASSERT_EQ(std::system(command.c_str()), 0);
  const std::string said = file_content(info);
  for (const char* layer :
       {"elevation", "variance", "slope", "step_height", "roughness", "traversability"}) {
    EXPECT_NE(said.find(std::string("Description = ") + layer), std::string::npos) << said;
  }
  EXPECT_NE(said.find("Pixel Size = (0.25"), std::string::npos) << said;
  EXPECT_NE(said.find("NoData Value=nan"), std::string::npos) << said;
}

TEST_F(MapCommand, IsFoundAgainByItsOwnRecording) {
  const ProcessResult result = surefoot({"run", "in", "-o", "again", "--localize", "map", "--start",
                                         "5", "--no-report", "--no-picture", "--no-map"});
  ASSERT_EQ(result.exit_code, 0) << result;
  EXPECT_NE(result.output.find("found in the map after"), std::string::npos) << result;
  const Trajectory found = io::read_tum(path("again/trajectory_map.tum"));
  const Trajectory before = io::read_tum(path("map/trajectory_optimized.tum"));
  ASSERT_GT(found.size(), 10U);
  const Pose& last = found.back().pose;
  EXPECT_LT((last.translation - before.back().pose.translation).norm(), 0.2);
  EXPECT_EQ(lines_of(path("again/localization.csv")), 56U);  // its head and 55 scans
  EXPECT_NE(file_content(path("again/localization.csv")).find(",\"found\"\n"), std::string::npos);
  const std::string told = file_content(path("again/run.yaml"));  // from wherever it is repeated
  EXPECT_NE(told.find("localize: " + path("map").string()), std::string::npos) << told;
}

/// The first scans' clock was an hour ahead.
TEST_F(MapCommand, IsFoundSoonWhereTheClockWasSetBack) {
  const ProcessResult taken = surefoot({"convert", "in", "set_back"});
  ASSERT_EQ(taken.exit_code, 0) << taken;
  std::istringstream stamps(file_content(path("set_back/times.txt")));
  std::string set_back;
  std::size_t scans = 0;
  for (std::string stamp; std::getline(stamps, stamp); ++scans) {
    const std::size_t point = stamp.find('.');
    ASSERT_NE(point, std::string::npos) << stamp;
    const std::int64_t whole = std::stoll(stamp.substr(0, point)) + (scans < 5 ? 3600 : 0);
    set_back += std::to_string(whole) + stamp.substr(point) + '\n';
  }
  ASSERT_GT(scans, 50U);
  write_content(path("set_back/times.txt"), set_back);
  const ProcessResult result =
      surefoot({"run", "set_back", "-o", "later", "--no-repair-stamps", "--localize", "map",
                "--no-report", "--no-picture", "--no-map"});
  ASSERT_EQ(result.exit_code, 0) << result;
  const std::string told = "found in the map after ";
  const std::size_t at = result.output.find(told);
  ASSERT_NE(at, std::string::npos) << result;
  const double after = std::stod(result.output.substr(at + told.size()));
  EXPECT_GT(after, 0.0) << result;
  EXPECT_LT(after, 8.0) << result;
}

TEST_F(MapCommand, OneThatIsCutShortOrMissingIsRefused) {
  const std::string whole = file_content(path("map/map.surefoot"));
  write_content(path("half.surefoot"), whole.substr(0, whole.size() / 2));
  expect_refused({"export", "half.surefoot", "--ply", "half.ply"}, "half.surefoot");
  EXPECT_FALSE(fs::exists(path("half.ply")));
  expect_refused({"run", "in", "-o", "none", "--localize", "nowhere"}, "nowhere");
}

}  // namespace
}  // namespace surefoot::test
