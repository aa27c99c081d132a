// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/g2o_file.hpp"

#include <cmath>
#include <limits>
#include <locale>
#include <sstream>
#include <stdexcept>

namespace surefoot::mapping {

namespace {

constexpr std::size_t kMostPoses = 10'000'000;

class Line {
 public:
  Line(const std::string& text, std::size_t number) : in_(text), number_(number) {
    in_.imbue(std::locale::classic());
  }

  std::string word() {
    std::string text;
    in_ >> text;
    return text;
  }
  double value(const char* what) {
    double result = 0.0;
    if (!(in_ >> result) || !std::isfinite(result)) refuse(std::string("expected ") + what);
    return result;
  }
  std::size_t index() {
    long long result = -1;
    if (!(in_ >> result) || result < 0 || static_cast<std::size_t>(result) >= kMostPoses) {
      refuse("expected the number of a pose, 0 to 9999999");
    }
    return static_cast<std::size_t>(result);
  }
  Eigen::Vector3d vector(const char* what) {
    Eigen::Vector3d result;
    for (int i = 0; i < 3; ++i) result[i] = value(what);
    return result;
  }
  Pose pose_by_quaternion() {
    const Eigen::Vector3d at = vector("x y z");
    Eigen::Vector4d q;
    for (int i = 0; i < 4; ++i) q[i] = value("qx qy qz qw");
    if (!(q.norm() > 1e-6)) refuse("expected a quaternion that is not zero");
    return {Eigen::Quaterniond(q.normalized()), at};
  }
  Matrix6 upper_triangle() {
    Matrix6 result;
    for (int i = 0; i < 6; ++i) {
      for (int k = i; k < 6; ++k) result(i, k) = result(k, i) = value("21 numbers of information");
    }
    return result;
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const {
    throw std::invalid_argument("line " + std::to_string(number_) + ": " + why);
  }

  std::istringstream in_;
  std::size_t number_;
};

Pose& pose_at(PoseGraph& graph, std::size_t index) {
  if (graph.poses.size() <= index) graph.poses.resize(index + 1);
  return graph.poses[index];
}

void add_edge(PoseGraph& graph, PoseEdge edge) {
  pose_at(graph, std::max(edge.from, edge.to));
  edge.inlier = edge.to == edge.from + 1;
  graph.edges.push_back(edge);
}

void parse_line(Line& line, PoseGraph& graph) {
  const std::string kind = line.word();
  if (kind == "VERTEX_SE3:QUAT") {
    const std::size_t index = line.index();
    pose_at(graph, index) = line.pose_by_quaternion();
  } else if (kind == "EDGE_SE3:QUAT") {
    PoseEdge edge;
    edge.from = line.index();
    edge.to = line.index();
    edge.T_from_to = line.pose_by_quaternion();
    edge.information = line.upper_triangle();
    add_edge(graph, edge);
  } else if (kind == "EDGE3") {
    PoseEdge edge;
    edge.from = line.index();
    edge.to = line.index();
    edge.T_from_to.translation = line.vector("x y z");
    edge.T_from_to.rotation = from_roll_pitch_yaw(line.vector("roll pitch yaw"));
    const Matrix6 root = line.upper_triangle().triangularView<Eigen::Upper>();
    edge.information = root.transpose() * root;
    add_edge(graph, edge);
  }  // what else there is (FIX, parameters) says nothing about poses
}

}  // namespace

PoseGraph parse_g2o(std::string_view text) {
  PoseGraph graph;
  std::size_t number = 0;
  while (!text.empty()) {
    const auto end = std::min(text.find('\n'), text.size());
    Line line(std::string(text.substr(0, end)), ++number);
    parse_line(line, graph);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return graph;
}

std::string format_g2o(const PoseGraph& graph) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(std::numeric_limits<double>::max_digits10);
  const auto write = [&out](const Pose& pose) {
    for (int i = 0; i < 3; ++i) out << ' ' << pose.translation[i];
    for (int i = 0; i < 4; ++i) out << ' ' << pose.rotation.coeffs()[i];
  };
  for (std::size_t i = 0; i < graph.poses.size(); ++i) {
    out << "VERTEX_SE3:QUAT " << i;
    write(graph.poses[i]);
    out << '\n';
  }
  for (const PoseEdge& edge : graph.edges) {
    out << "EDGE_SE3:QUAT " << edge.from << ' ' << edge.to;
    write(edge.T_from_to);
    for (int i = 0; i < 6; ++i) {
      for (int k = i; k < 6; ++k) out << ' ' << edge.information(i, k);
    }
    out << '\n';
  }
  return out.str();
}

}  // namespace surefoot::mapping
