// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "report/run_picture.hpp"

#include <cairo.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <set>
#include <utility>

#include "report/panels.hpp"

// fontconfig keeps a few patterns of its font cache until the process ends.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libfontconfig"; }

namespace surefoot::report {
namespace {

namespace fs = std::filesystem;

// Where the panels' data are on the page.
struct Area {
  const char* name;
  int x, y, width, height;
};
constexpr Area kMap{"map", 48, 140, 1100, 780};
constexpr Area kTop{"top view", 1347, 182, 603, 676};
constexpr Area kSide{"side view", 1347, 992, 603, 416};
constexpr Area kHeightPanel{"height", 137, 992, 1076, 124};
constexpr Area kRoll{"roll", 137, 1138, 1076, 124};
constexpr Area kPitch{"pitch", 137, 1284, 1076, 124};
constexpr std::array<Area, 6> kPanels = {kMap, kTop, kSide, kHeightPanel, kRoll, kPitch};

struct Rgb {
  int red, green, blue;
};
constexpr Rgb kPathColor{214, 26, 66};
constexpr Rgb kStartColor{33, 102, 242};
constexpr Rgb kEndColor{255, 209, 26};
constexpr Rgb kUntrustedOnWhite{253, 210, 160};

class Image {
 public:
  explicit Image(const fs::path& path)
      : surface_(cairo_image_surface_create_from_png(path.c_str())) {}
  Image(const Image&) = delete;
  Image& operator=(const Image&) = delete;
  ~Image() { cairo_surface_destroy(surface_); }

  [[nodiscard]] bool valid() const {
    return cairo_surface_status(surface_) == CAIRO_STATUS_SUCCESS;
  }
  [[nodiscard]] std::uint32_t at(int x, int y) const {
    const unsigned char* row = cairo_image_surface_get_data(surface_) +
                               std::ptrdiff_t{y} * cairo_image_surface_get_stride(surface_);
    return reinterpret_cast<const std::uint32_t*>(row)[x] & 0xFFFFFFU;
  }
  [[nodiscard]] int count(const Area& area, const Rgb& color) const {
    int found = 0;
    for_each(area, [&](int x, int y) { found += is_near(at(x, y), color); });
    return found;
  }
  [[nodiscard]] std::size_t colors(const Area& area) const {
    std::set<std::uint32_t> seen;
    for_each(area, [&](int x, int y) { seen.insert(at(x, y)); });
    return seen.size();
  }

 private:
  template <typename Use>
  static void for_each(const Area& area, Use use) {
    for (int y = area.y; y < area.y + area.height; ++y) {
      for (int x = area.x; x < area.x + area.width; ++x) use(x, y);
    }
  }
  static bool is_near(std::uint32_t rgb, const Rgb& color) {
    const auto channel = [&](int shift) { return static_cast<int>(rgb >> shift & 0xFFU); };
    return std::abs(channel(16) - color.red) <= 4 && std::abs(channel(8) - color.green) <= 4 &&
           std::abs(channel(0) - color.blue) <= 4;
  }
  cairo_surface_t* surface_;
};

std::string bytes_of_picture(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

unsigned big_endian(const std::string& bytes, std::size_t at) {
  unsigned value = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    value = value << 8 | static_cast<unsigned char>(bytes.at(at + i));
  }
  return value;
}

// A walk along a slow curve up a slope, rolling and pitching, at 10 Hz.
Trajectory walk(int poses) {
  Trajectory trajectory;
  for (int i = 0; i < poses; ++i) {
    const double s = 0.1 * i;
    const Eigen::Vector3d angles(0.05 * std::sin(3.0 * s), -0.1 + 0.03 * std::sin(5.0 * s),
                                 0.2 * s);
    trajectory.push_back({1'700'000'000'000'000'000 + i * 100'000'000LL,
                          {from_roll_pitch_yaw(angles),
                           {5.0 * std::sin(0.2 * s), 5.0 - 5.0 * std::cos(0.2 * s), 0.1 * s}}});
  }
  return trajectory;
}

std::vector<Eigen::Vector3f> room() {
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < 200; ++i) {
    for (int j = 0; j < 200; ++j) {
      const float a = -8.0F + 0.08F * static_cast<float>(i), b = 0.08F * static_cast<float>(j);
      points.emplace_back(a, b - 4.0F, -0.5F);
      points.emplace_back(a, 12.0F, 0.25F * b);
    }
  }
  return points;
}

class RunPicture : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / ("surefoot_" + std::string(test->name()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path folder_;
};

TEST_F(RunPicture, IsAPngOfTheStatedSizeWithSomethingInEachPanel) {
  const std::vector<Eigen::Vector3f> points = room();
  const fs::path path = folder_ / "run.png";
  draw_run_picture({.title = "Walk", .trajectory = walk(100), .map_points = points}, path);
  const std::string bytes = bytes_of_picture(path);
  ASSERT_GT(bytes.size(), 33U);
  EXPECT_EQ(bytes.substr(0, 8), "\x89PNG\r\n\x1a\n");
  EXPECT_EQ(big_endian(bytes, 16), static_cast<unsigned>(kPictureWidth));
  EXPECT_EQ(big_endian(bytes, 20), static_cast<unsigned>(kPictureHeight));
  const Image image(path);
  ASSERT_TRUE(image.valid());
  for (const Area& panel : kPanels) {
    EXPECT_GT(image.count(panel, kPathColor), 300) << panel.name;
  }
  for (const Area& panel : {kMap, kTop, kSide}) {
    EXPECT_GT(image.count(panel, kStartColor), 200) << panel.name;
    EXPECT_GT(image.count(panel, kEndColor), 150) << panel.name;
  }
  EXPECT_GT(image.colors(kMap), 300U) << "the map is coloured by height";
}

TEST_F(RunPicture, UntrustedPosesAreShadedAtTheirTime) {
  Trajectory trajectory = walk(101);
  std::vector<bool> untrusted(101, false);
  for (std::size_t i = 50; i <= 60; ++i) untrusted[i] = true;
  const fs::path path = folder_ / "run.png";
  draw_run_picture({.title = "", .trajectory = trajectory, .untrusted = untrusted}, path);
  const Image image(path);
  ASSERT_TRUE(image.valid());
  // 10 s over 1080 px: the band is from 4.95 s to 6.05 s.
  for (const Area& panel : {kHeightPanel, kRoll, kPitch}) {
    const Area before{"", panel.x, panel.y, 530, panel.height};
    const Area within{"", 135 + 540, panel.y, 100, panel.height};
    const Area after{"", 135 + 660, panel.y, 410, panel.height};
    EXPECT_EQ(image.count(before, kUntrustedOnWhite), 0);
    EXPECT_GT(image.count(within, kUntrustedOnWhite), 5000);
    EXPECT_EQ(image.count(after, kUntrustedOnWhite), 0);
  }
  EXPECT_GT(image.count(kTop, kUntrustedOnWhite), 100);
}

/// The second segment begins 5 m higher: how the two lie to each other is not known.
TEST_F(RunPicture, NoLineJoinsSegments) {
  Trajectory trajectory = walk(100);
  std::vector<int> segments(100, 0);
  for (std::size_t i = 50; i < 100; ++i) {
    trajectory[i].pose.translation.z() += 5.0;
    segments[i] = 1;
  }
  const auto between = [&](const std::vector<int>& of) {
    draw_run_picture({.title = "", .trajectory = trajectory, .segments = of}, folder_ / "run.png");
    const Image image(folder_ / "run.png");
    int found = 0;
    for (const Area& panel : {kHeightPanel, kSide}) {
      found += image.count({"", panel.x, panel.y + panel.height / 2 - 8, panel.width, 16},
                           kPathColor) > 0
                   ? 1
                   : 0;
    }
    return found;
  };
  EXPECT_EQ(between({}), 2);
  EXPECT_EQ(between(segments), 0);
}

TEST_F(RunPicture, ASegmentOfASinglePoseIsADot) {
  std::vector<int> segments;
  for (int i = 0; i < 20; ++i) segments.push_back(i);
  draw_run_picture({.title = "", .trajectory = walk(20), .segments = segments},
                   folder_ / "run.png");
  const Image image(folder_ / "run.png");
  for (const Area& panel : kPanels) EXPECT_GT(image.count(panel, kPathColor), 50) << panel.name;
}

TEST_F(RunPicture, OfWhoStandsTheSurroundingsAreSeen) {
  std::vector<Eigen::Vector3f> circle;
  for (int i = 0; i < 360; ++i) {
    const auto angle = 0.0175F * static_cast<float>(i);
    circle.emplace_back(4.0F * std::cos(angle), 4.0F * std::sin(angle), 0.0F);
  }
  const Trajectory stay(5, walk(1).front());
  draw_run_picture({.title = "", .trajectory = stay}, folder_ / "without.png");
  draw_run_picture({.title = "", .trajectory = stay, .map_points = circle}, folder_ / "with.png");
  EXPECT_GT(Image(folder_ / "with.png").colors(kTop), Image(folder_ / "without.png").colors(kTop));
}

TEST_F(RunPicture, ReferenceIsABandUnderThePath) {
  Trajectory reference = walk(100);
  for (StampedPose& stamped : reference) {
    stamped.pose.translation += Eigen::Vector3d(0.5, -0.5, 0.2);
  }
  const Rgb band{159, 177, 211};
  const Area middle{"middle of the top view", 1400, 250, 500, 540};
  draw_run_picture({.title = "", .trajectory = walk(100)}, folder_ / "without.png");
  draw_run_picture({.title = "", .trajectory = walk(100), .reference = reference},
                   folder_ / "with.png");
  const Image without(folder_ / "without.png"), with(folder_ / "with.png");
  EXPECT_GT(with.count(middle, band), without.count(middle, band) + 200);
  // Where both are the same the path is still to be seen.
  draw_run_picture({.title = "", .trajectory = walk(100), .reference = walk(100)},
                   folder_ / "same.png");
  EXPECT_GT(Image(folder_ / "same.png").count(middle, kPathColor), 500);
}

TEST_F(RunPicture, LoopsAreDrawnFromAboveAndTheWayAfterThemByHeight) {
  const Trajectory path = walk(100);
  const auto places = [&](std::size_t from, std::size_t to) {
    return std::pair(path[from].pose.translation, path[to].pose.translation);
  };
  const Rgb loop{15, 138, 94};
  DrawnLoops loops;
  loops.refused = {places(0, 60)};
  loops.corrected = path;
  draw_run_picture({.title = "", .trajectory = path, .loops = loops}, folder_ / "refused.png");
  const Image refused(folder_ / "refused.png");
  EXPECT_EQ(refused.count(kTop, loop), 0) << "no loop has moved anything";
  EXPECT_EQ(refused.count(kSide, loop), 0);
  loops.taken = {places(0, 99),
                 {Eigen::Vector3d::Zero(),
                  Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN())}};
  draw_run_picture({.title = "", .trajectory = path, .loops = loops}, folder_ / "taken.png");
  const Image image(folder_ / "taken.png");
  EXPECT_GT(image.count(kTop, loop), 300);
  EXPECT_GT(image.count(kSide, loop), 300);
}

/// Ten metres along, and as many on once the clock was set back by half the time so far, 0.4 m
/// higher after loops.
TEST_F(RunPicture, TheWayAfterLoopsGoesOnWhereTheClockWasSetBack) {
  PictureInput input{.title = ""};
  for (int i = 0; i < 200; ++i) {
    const std::int64_t stamp = (i < 100 ? i : i - 50) * 100'000'000LL;
    const Eigen::Vector3d at(0.1 * i, 0.0, 0.0);
    input.trajectory.push_back({stamp, {Eigen::Quaterniond::Identity(), at}});
    input.loops.corrected.push_back(input.trajectory.back());
    if (i >= 100) input.loops.corrected.back().pose.translation.z() = 0.4;
  }
  input.loops.taken = {{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX()}};
  draw_run_picture(input, folder_ / "run.png");
  const Image image(folder_ / "run.png");
  const Rgb loop{15, 138, 94};
  const int half_width = kSide.width / 2, high = kSide.height / 2 - 10;
  EXPECT_EQ(image.count({"", kSide.x, kSide.y, half_width - 8, high}, loop), 0);
  EXPECT_GT(image.count({"", kSide.x + half_width, kSide.y, half_width, high}, loop), 100);
}

/// Up a ramp of a tenth that leads along y.
TEST_F(RunPicture, ARampIsARampInWhicheverDirectionItLeads) {
  Trajectory ramp;
  for (int i = 0; i < 200; ++i) {
    ramp.push_back({i * 100'000'000LL, {Eigen::Quaterniond::Identity(), {0.0, 0.1 * i, 0.01 * i}}});
  }
  draw_run_picture({.title = "", .trajectory = ramp, .reference = ramp}, folder_ / "run.png");
  const Image image(folder_ / "run.png");
  ASSERT_TRUE(image.valid());
  // The lower left and the upper right quarter hold it, the others nothing.
  const int half_width = kSide.width / 2, half_height = kSide.height / 2;
  const Area lower_left{"", kSide.x, kSide.y + half_height, half_width, half_height};
  const Area upper_right{"", kSide.x + half_width, kSide.y, half_width, half_height};
  const Area upper_left{"", kSide.x, kSide.y, half_width - 20, half_height - 20};
  EXPECT_GT(image.count(lower_left, kPathColor), 300);
  EXPECT_GT(image.count(upper_right, kPathColor), 300);
  EXPECT_EQ(image.count(upper_left, kPathColor), 0);
}

TEST_F(RunPicture, ALevelFloorLooksLevel) {
  Trajectory corridor;
  for (int i = 0; i < 400; ++i) {
    corridor.push_back(
        {i * 100'000'000LL, {Eigen::Quaterniond::Identity(), {0.1 * i, 0.0, -5e-5 * i}}});
  }
  draw_run_picture({.title = "", .trajectory = corridor}, folder_ / "run.png");
  const Image image(folder_ / "run.png");
  ASSERT_TRUE(image.valid());
  const Area above{"", kSide.x, kSide.y, kSide.width, 2 * kSide.height / 5};
  const Area below{"", kSide.x, kSide.y + 3 * kSide.height / 5, kSide.width, 2 * kSide.height / 5};
  EXPECT_EQ(image.count(above, kPathColor), 0);
  EXPECT_EQ(image.count(below, kPathColor), 0) << "2 cm over 40 m";
}

TEST_F(RunPicture, TheSameInputGivesTheSameBytes) {
  const std::vector<Eigen::Vector3f> points = room();
  const PictureInput input{
      .title = "Walk", .trajectory = walk(100), .map_points = points, .reference = walk(90)};
  draw_run_picture(input, folder_ / "a.png");
  draw_run_picture(input, folder_ / "b.png");
  EXPECT_EQ(bytes_of_picture(folder_ / "a.png"), bytes_of_picture(folder_ / "b.png"));
}

TEST(DrawnRun, LastsFromTheLeastStampToTheGreatest) {
  PictureInput input{.trajectory = {{5'000, {}}, {9'000, {}}, {2'000, {}}, {4'000, {}}}};
  const DrawnRun run = prepare_run(input);  // its clock was set back
  EXPECT_EQ(run.first_ns, 2'000);
  EXPECT_EQ(run.last_ns, 9'000);
}

TEST_F(RunPicture, SvgIsWrittenByExtension) {
  draw_run_picture({.title = "Walk", .trajectory = walk(10)}, folder_ / "run.svg");
  const std::string text = bytes_of_picture(folder_ / "run.svg");
  EXPECT_NE(text.find("<svg"), std::string::npos);
  EXPECT_NE(text.find("</svg>"), std::string::npos);
}

TEST_F(RunPicture, DegenerateInputIsStillAPicture) {
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  const float nan_f = std::nanf("");
  const auto at = [](double x, double y, double z) {
    StampedPose stamped;
    stamped.pose.translation = {x, y, z};
    return stamped;
  };
  StampedPose no_rotation = at(0, 0, 0), nan_rotation = at(0, 0, 0);
  no_rotation.pose.rotation.coeffs().setZero();
  nan_rotation.pose.rotation.coeffs().setConstant(nan);
  StampedPose first = at(0, 0, 0), last = at(1, 1, 1);
  first.stamp_ns = std::numeric_limits<std::int64_t>::min();
  last.stamp_ns = std::numeric_limits<std::int64_t>::max();
  const std::vector<Trajectory> trajectories = {
      {},
      {at(0, 0, 0)},
      {at(1, 2, 3), at(1, 2, 3)},
      Trajectory(50, at(7, 7, 7)),
      {at(nan, 0, 0), at(0, inf, 0), at(0, 0, -inf)},
      {no_rotation, nan_rotation, at(1, 0, 0)},
      {at(-1e9, -1e9, -1e9), at(1e9, 1e9, 1e9)},
      {at(1e300, 0, 0), at(0, 0, 0)},
      {at(458000.0, 5429380.0, 162.9), at(458000.01, 5429380.0, 162.9)},
      {first, last},
      {last, first},
  };
  const std::vector<std::vector<Eigen::Vector3f>> maps = {
      {},
      {{0.0F, 0.0F, 0.0F}},
      std::vector<Eigen::Vector3f>(1000, {1.0F, 1.0F, 1.0F}),
      std::vector<Eigen::Vector3f>(10, {nan_f, nan_f, nan_f}),
      {{-1e9F, -1e9F, -1e9F}, {1e9F, 1e9F, 1e9F}, {3e38F, 0.0F, 0.0F}},
  };
  const fs::path path = folder_ / "run.png";
  for (std::size_t i = 0; i < trajectories.size(); ++i) {
    const auto& map = maps[i % maps.size()];
    fs::remove(path);
    draw_run_picture({.title = "", .trajectory = trajectories[i], .map_points = map}, path);
    EXPECT_TRUE(Image(path).valid()) << "trajectory " << i;
  }
  for (std::size_t i = 0; i < maps.size(); ++i) {
    fs::remove(path);
    draw_run_picture({.title = "", .trajectory = {}, .map_points = maps[i]}, path);
    EXPECT_TRUE(Image(path).valid()) << "map " << i;
  }
}

TEST_F(RunPicture, TitlesThatAreNotUtf8OrVeryLongDoNotSpoilThePicture) {
  const std::string titles[] = {
      "\xFF\xFE", "\xC3",    "\xE2\x82",           "\xED\xA0\x80",
      "\xC0\xAF", "a\nb\tc", "Gr\xC3\xBC\xC3\x9F", std::string(5000, 'w')};
  for (const std::string& title : titles) {
    const fs::path path = folder_ / "run.png";
    fs::remove(path);
    draw_run_picture({.title = title, .trajectory = walk(20)}, path);
    const Image image(path);
    ASSERT_TRUE(image.valid());
    EXPECT_GT(image.count(kTop, kPathColor), 300) << "drawn after the title";
  }
}

TEST_F(RunPicture, ErrorsNameThePathAndWhatWasSeen) {
  const auto message = [](const PictureInput& input, const fs::path& path) -> std::string {
    try {
      draw_run_picture(input, path);
    } catch (const std::exception& error) {
      return error.what();
    }
    return "nothing thrown";
  };
  const PictureInput input{.title = "", .trajectory = walk(3)};
  const std::string missing = (folder_ / "no_such_folder" / "run.png").string();
  EXPECT_NE(message(input, missing).find(missing), std::string::npos);
  const std::string jpeg = (folder_ / "run.jpg").string();
  EXPECT_NE(message(input, jpeg).find(jpeg), std::string::npos);
  EXPECT_FALSE(fs::exists(jpeg));
  EXPECT_THROW(draw_run_picture(input, folder_), std::runtime_error);
  const PictureInput short_flags{.title = "", .trajectory = walk(3), .untrusted = {true}};
  EXPECT_EQ(message(short_flags, folder_ / "run.png"), "draw_run_picture: 1 flags for 3 poses");
}

}  // namespace
}  // namespace surefoot::report
