// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "report/trajectory_figure.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <stdexcept>

#include "png_image.hpp"

namespace surefoot::report {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t kBlue = 0x0072B2, kVermilion = 0xD55E00, kStart = 0x2166F2, kEnd = 0xFFD11A;
constexpr FigureView kViews[] = {FigureView::space, FigureView::side, FigureView::top};

Trajectory loop(double radius, double height, int poses = 200) {
  Trajectory trajectory;
  for (int i = 0; i < poses; ++i) {
    const double angle = 0.03 * i;
    trajectory.push_back(
        {i,
         {Eigen::Quaterniond::Identity(),
          {radius * std::cos(angle), radius * std::sin(angle), height + 0.01 * i}}});
  }
  return trajectory;
}

TrajectoryFigure figure_of(FigureView view, std::size_t panels) {
  TrajectoryFigure figure{{"first", "second"}, {}};
  for (std::size_t i = 0; i < panels; ++i) {
    figure.panels.push_back(
        {view, "hall", loop(10.0, 0.0), {loop(10.5, 0.3), loop(9.0, -0.5)}, {}, {}});
  }
  return figure;
}

fs::path scratch(const std::string& name) {
  return fs::path(testing::TempDir()) / ("trajectory_figure_" + name);
}

std::string bytes_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

TEST(TrajectoryFigure, EveryViewShowsEveryCurveAndBothMarkers) {
  for (const FigureView view : kViews) {
    const fs::path path = scratch("view.png");
    draw_trajectory_figure(figure_of(view, 1), path);
    const PngImage image(path);
    ASSERT_TRUE(image.valid());
    EXPECT_EQ(image.at(0, 0), 0xFFFFFFU);
    // A sample in the legend alone has about 600 pixels.
    EXPECT_GT(image.count(kBlue), 1500) << static_cast<int>(view);
    EXPECT_GT(image.count(kVermilion), 1000) << static_cast<int>(view);
    EXPECT_GT(image.count(kStart), 500) << static_cast<int>(view);
    EXPECT_GT(image.count(kEnd), 300) << static_cast<int>(view);
  }
}

// Half a turn, and the same again far away: a line from the one to the other would add pixels.
TEST(TrajectoryFigure, NoLineLeadsFromASegmentToAnother) {
  Trajectory two = loop(10.0, 0.0, 100);
  for (const StampedPose& pose : loop(10.0, 0.0, 100)) two.push_back(pose);
  two[100].pose.translation.x() = std::numeric_limits<double>::quiet_NaN();  // is not drawn
  for (const FigureView view : kViews) {
    TrajectoryFigure figure = figure_of(view, 1);
    figure.panels[0].estimates = {two, {}};
    const fs::path one = scratch("one.png"), apart = scratch("apart.png");
    draw_trajectory_figure(figure, one);
    figure.panels[0].begins = {{100}, {}};
    draw_trajectory_figure(figure, apart);
    EXPECT_GT(PngImage(one).count(kBlue), PngImage(apart).count(kBlue) + 200)
        << static_cast<int>(view);
  }
}

TEST(TrajectoryFigure, APanelForEachSequence) {
  int last_height = 0;
  for (const std::size_t panels : {1U, 4U, 13U}) {
    const fs::path path = scratch("panels.png");
    draw_trajectory_figure(figure_of(FigureView::top, panels), path);
    const PngImage image(path);
    EXPECT_GT(image.height(), last_height);
    EXPECT_GT(image.count(kBlue), static_cast<int>(panels) * 1000);
    last_height = image.height();
  }
}

// A picture of 32,768 dots or more in height cannot be made.
TEST(TrajectoryFigure, APageOfHundredsOfPanelsIsDrawn) {
  for (const std::size_t panels : {120U, 300U}) {
    TrajectoryFigure figure{{"m"}, {}};
    figure.panels.assign(panels, {FigureView::top, "hall", {}, {{}}, {}, {}});
    const fs::path path = scratch("hundreds.png");
    draw_trajectory_figure(figure, path);
    const PngImage image(path);
    ASSERT_TRUE(image.valid());
    EXPECT_GT(image.width() * (image.height() / 100), 300 * static_cast<int>(panels)) << panels;
    fs::remove(path);
  }
}

TEST(TrajectoryFigure, PngIsTheSameTwice) {
  const fs::path a = scratch("a.png"), b = scratch("b.png"), svg = scratch("a.svg");
  draw_trajectory_figure(figure_of(FigureView::space, 2), a);
  draw_trajectory_figure(figure_of(FigureView::space, 2), b);
  EXPECT_TRUE(bytes_of(a) == bytes_of(b));
  draw_trajectory_figure(figure_of(FigureView::space, 2), svg);
  EXPECT_NE(bytes_of(svg).find("<svg"), std::string::npos);
}

// A method that flies away neither moves the axes nor is it drawn outside of them.
TEST(TrajectoryFigure, WhatIsCutDoesNotWidenTheAxes) {
  for (const FigureView view : kViews) {
    const fs::path plain = scratch("plain.png"), cut = scratch("cut.png");
    TrajectoryFigure figure = figure_of(view, 1);
    figure.panels[0].estimates[1].clear();
    draw_trajectory_figure(figure, plain);
    Trajectory away = loop(10.0, 0.0);
    for (StampedPose& pose : away) pose.pose.translation += Eigen::Vector3d(1e4, 1e4, 1e4);
    figure.panels[0].estimates[1] = away;
    figure.panels[0].cut = {false, true};
    draw_trajectory_figure(figure, cut);
    EXPECT_TRUE(bytes_of(plain) == bytes_of(cut)) << static_cast<int>(view);
  }
}

// Without cutting, cairo would lay dashes along all of these lines.
TEST(TrajectoryFigure, JumpsToTheEndOfTheWorldTakeNoTime) {
  Trajectory jumping = loop(10.0, 0.0);
  for (std::size_t i = 0; i < jumping.size(); i += 2) jumping[i].pose.translation *= 5e7;
  for (const FigureView view : kViews) {
    TrajectoryFigure figure = figure_of(view, 1);
    figure.panels[0].estimates = {jumping, jumping};
    const auto begin = std::chrono::steady_clock::now();
    draw_trajectory_figure(figure, scratch("jumps.png"));
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(30));
  }
}

TEST(TrajectoryFigure, OddInputIsDrawn) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double huge = std::numeric_limits<double>::max();
  Trajectory bad = loop(1.0, 0.0, 5);
  bad[1].pose.translation = {nan, 0.0, 0.0};
  bad[2].pose.translation = {huge, -huge, huge};
  const Trajectory standing(10, StampedPose{0, {Eigen::Quaterniond::Identity(), {5e8, 0, 0}}});
  for (const FigureView view : kViews) {
    for (const Trajectory& odd :
         {Trajectory(), bad, standing, Trajectory(bad.begin(), bad.begin() + 1)}) {
      const fs::path path = scratch("odd.png");
      TrajectoryFigure figure{{"m"}, {{view, "\xFF", odd, {odd}, {}, {"a remark"}}}};
      EXPECT_NO_THROW(draw_trajectory_figure(figure, path));
      EXPECT_TRUE(PngImage(path).valid());
    }
  }
}

TEST(TrajectoryFigure, NonsenseIsRefused) {
  const fs::path path = scratch("none.png");
  EXPECT_THROW(draw_trajectory_figure({{"a"}, {}}, path), std::invalid_argument);
  TrajectoryFigure figure = figure_of(FigureView::top, 1);
  EXPECT_THROW(draw_trajectory_figure(figure, "figure.gif"), std::runtime_error);
  EXPECT_THROW(draw_trajectory_figure(figure, "/nowhere/figure.png"), std::runtime_error);
  figure.panels[0].cut = {true};
  EXPECT_THROW(draw_trajectory_figure(figure, path), std::invalid_argument);
  figure.panels[0].cut = {};
  figure.panels[0].estimates.pop_back();
  EXPECT_THROW(draw_trajectory_figure(figure, path), std::invalid_argument);
}

}  // namespace
}  // namespace surefoot::report
