// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/g2o_file.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "support/random.hpp"

namespace surefoot::mapping {
namespace {

TEST(G2oFile, ReadsBackEveryBit) {
  test::Random random(1);
  PoseGraph graph;
  for (int i = 0; i < 5; ++i) {
    graph.poses.push_back({so3_exp(random.vector(2.0)), random.vector(100.0)});
  }
  for (std::size_t i = 0; i < 4; ++i) {
    PoseEdge edge;
    edge.from = i;
    edge.to = i == 3 ? 0 : i + 1;
    edge.T_from_to = {so3_exp(random.vector(1.0)), random.vector(10.0)};
    const Matrix6 root = Matrix6::Random();
    edge.information = root * root.transpose();
    graph.edges.push_back(edge);
  }
  const PoseGraph back = parse_g2o(format_g2o(graph));
  ASSERT_EQ(back.poses.size(), graph.poses.size());
  ASSERT_EQ(back.edges.size(), graph.edges.size());
  for (std::size_t i = 0; i < graph.poses.size(); ++i) {
    EXPECT_EQ(back.poses[i].translation, graph.poses[i].translation);
    EXPECT_LT(back.poses[i].rotation.angularDistance(graph.poses[i].rotation), 1e-15);
  }
  for (std::size_t i = 0; i < graph.edges.size(); ++i) {
    EXPECT_EQ(back.edges[i].from, graph.edges[i].from);
    EXPECT_EQ(back.edges[i].to, graph.edges[i].to);
    EXPECT_LT((back.edges[i].information - graph.edges[i].information).norm(), 1e-14);
    EXPECT_EQ(back.edges[i].inlier, graph.edges[i].to == graph.edges[i].from + 1);
  }
}

TEST(G2oFile, EdgesOfIsamHoldRollPitchYawAndTheRootOfTheInformation) {
  const PoseGraph graph =
      parse_g2o("EDGE3 0 1 1 2 3 0.1 0.2 0.3 10 0 0 0 0 1 10 0 0 0 0 10 0 0 0 100 0 0 100 0 25\n");
  ASSERT_EQ(graph.edges.size(), 1U);
  const PoseEdge& edge = graph.edges.front();
  EXPECT_LT((roll_pitch_yaw(edge.T_from_to.rotation) - Eigen::Vector3d(0.1, 0.2, 0.3)).norm(),
            1e-12);
  EXPECT_DOUBLE_EQ(edge.information(0, 0), 100.0);
  EXPECT_DOUBLE_EQ(edge.information(0, 5), 10.0);
  EXPECT_DOUBLE_EQ(edge.information(5, 5), 626.0);
}

TEST(G2oFile, BadLinesAreNamed) {
  const auto message = [](const char* text) -> std::string {
    try {
      (void)parse_g2o(text);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(message("\nVERTEX_SE3:QUAT 0 0 0 0 0 0 0 0\n").find("line 2"), std::string::npos);
  EXPECT_NE(message("VERTEX_SE3:QUAT -1 0 0 0 0 0 0 1").find("number of a pose"),
            std::string::npos);
  EXPECT_NE(message("VERTEX_SE3:QUAT 99999999999 0 0 0 0 0 0 1").find("number of a pose"),
            std::string::npos);
  EXPECT_NE(message("EDGE_SE3:QUAT 0 1 0 0 0 0 0 0 1 1 0").find("21 numbers"), std::string::npos);
  EXPECT_NE(message("VERTEX_SE3:QUAT 0 0 0 nan 0 0 0 1").find("x y z"), std::string::npos);
  EXPECT_EQ(message("FIX 0\n# a remark\n"), "");
}

}  // namespace
}  // namespace surefoot::mapping
