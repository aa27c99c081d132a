// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// evo (github.com/MichaelGrupp/evo) v1.36.5 on its own test data gave the figures in
// evo_figures.csv, through make_evo_figures.py. Ours have to be the same.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

#include "evaluation/alignment.hpp"
#include "evaluation/ape.hpp"
#include "evaluation/association.hpp"
#include "evaluation/rpe.hpp"
#include "evaluation/statistics.hpp"
#include "evo_data.hpp"

namespace surefoot::evaluation {
namespace {

// Absolute; relative of sums of squares, which may be large, and of percents, which divide by steps
// of millimetres where coordinates are resolved to nanometres.
constexpr double kTolerance = 1e-6;

struct EvoFigures {
  std::string data, metric, relation, alignment;
  std::size_t alignment_poses = 0;
  PairOptions stretches;
  bool from_reference = false;
  Statistics statistics;
};

EvoFigures parse(const std::string& line) {
  std::istringstream fields(line);
  std::vector<std::string> f;
  for (std::string field; std::getline(fields, field, ',');) f.push_back(field);
  const std::map<std::string, DeltaUnit> units = {{"", DeltaUnit::frames},
                                                  {"frames", DeltaUnit::frames},
                                                  {"metres", DeltaUnit::metres},
                                                  {"degrees", DeltaUnit::degrees}};
  const auto number = [&](std::size_t i) { return std::stod(f.at(i)); };
  return {f.at(0),
          f.at(1),
          f.at(2),
          f.at(3),
          std::stoul(f.at(4)),
          {.delta = number(5), .unit = units.at(f.at(6)), .all_pairs = f.at(7) == "1"},
          f.at(8) == "1",
          {std::stoul(f.at(9)), number(10), number(11), number(12), number(13), number(14),
           number(15), number(16)}};
}

std::vector<EvoFigures> read_figures(const std::string& data) {
  std::ifstream file(std::string(SUREFOOT_SOURCE_DIR) + "/tests/unit/evaluation/evo_figures.csv");
  std::vector<EvoFigures> all;
  for (std::string line; std::getline(file, line);) {
    if (line.rfind(data + ",", 0) == 0) all.push_back(parse(line));
  }
  return all;
}

AssociatedTrajectories read_pairs(const std::string& data) {
  using test::evo_data, test::read_kitti, test::read_tum;
  if (data.rfind("kitti_", 0) == 0) {
    return associate(read_kitti(evo_data("KITTI_00_gt.txt")),
                     read_kitti(evo_data("KITTI_00_" + data.substr(6) + ".txt")),
                     {.method = AssociationMethod::index});
  }
  if (data == "v102") {
    return associate(test::read_euroc(evo_data("V102_groundtruth.csv")),
                     read_tum(evo_data("V102.txt")), {});
  }
  if (data == "georeferenced") {  // each pose against the next one
    const Trajectory all = read_tum(evo_data("georeferenced.tum"));
    return {{all.begin(), all.end() - 1}, {all.begin() + 1, all.end()}};
  }
  const std::map<std::string, std::pair<const char*, const char*>> files = {
      {"fr2_desk", {"fr2_desk_groundtruth.txt", "fr2_desk_ORB.txt"}},
      {"fr1_xyz", {"freiburg1_xyz-groundtruth.txt", "freiburg1_xyz-rgbdslam.txt"}},
      {"fr1_drift", {"freiburg1_xyz-groundtruth.txt", "freiburg1_xyz-rgbdslam_drift.txt"}}};
  const auto& [reference, estimate] = files.at(data);
  const Trajectory truth = read_tum(evo_data(reference));
  Trajectory estimated = read_tum(evo_data(estimate));
  // This one stamp is midway between two of the truth's. evo keeps stamps as floating-point
  // seconds, whose rounding takes it to the later one.
  for (StampedPose& stamped : estimated) {
    if (stamped.stamp_ns == 1'311'868'226'310'950'000) stamped.stamp_ns += 1;
  }
  return associate(truth, estimated, {});
}

AlignmentMethod alignment_of(const std::string& name) {
  return std::map<std::string, AlignmentMethod>{{"none", AlignmentMethod::none},
                                                {"origin", AlignmentMethod::origin},
                                                {"rigid", AlignmentMethod::rigid},
                                                {"similarity", AlignmentMethod::similarity},
                                                {"scale", AlignmentMethod::scale}}
      .at(name);
}

std::vector<double> errors_of(const EvoFigures& figures, AssociatedTrajectories pairs) {
  const TrajectoryAlignment alignment =
      find_alignment(pairs, alignment_of(figures.alignment), figures.alignment_poses);
  pairs.estimate = aligned(pairs.estimate, alignment);
  const std::map<std::string, Relation> relations = {{"translation", Relation::translation},
                                                     {"rotation_angle", Relation::rotation_angle},
                                                     {"rotation_part", Relation::rotation_part},
                                                     {"full", Relation::full}};
  if (figures.metric == "ape") return absolute_errors(pairs, relations.at(figures.relation));
  const std::vector<IndexPair> stretches =
      find_pairs(figures.from_reference ? pairs.reference : pairs.estimate, figures.stretches);
  if (figures.relation == "distance") return relative_distance_errors(pairs, stretches);
  if (figures.relation == "distance_percent") {
    return relative_distance_error_percents(pairs, stretches);
  }
  return relative_errors(pairs, stretches, relations.at(figures.relation));
}

class EvoAgreement : public testing::TestWithParam<const char*> {};

TEST_P(EvoAgreement, EveryFigureOfApeAndRpe) {
  if (!std::filesystem::exists(test::evo_data("KITTI_00_gt.txt"))) {
    GTEST_SKIP() << "evo's test data are not at hand";
  }
  const AssociatedTrajectories pairs = read_pairs(GetParam());
  const std::vector<EvoFigures> all = read_figures(GetParam());
  ASSERT_GT(all.size(), 100U);
  for (const EvoFigures& evo : all) {
    SCOPED_TRACE(evo.metric + " " + evo.relation + ", alignment " + evo.alignment + " " +
                 std::to_string(evo.alignment_poses) + ", delta " +
                 std::to_string(evo.stretches.delta) + " unit " +
                 std::to_string(static_cast<int>(evo.stretches.unit)) +
                 (evo.stretches.all_pairs ? " all pairs" : ""));
    const Statistics ours = statistics_of(errors_of(evo, pairs));
    EXPECT_EQ(ours.count, evo.statistics.count);
    for (const auto member :
         {&Statistics::max, &Statistics::mean, &Statistics::median, &Statistics::min,
          &Statistics::rmse, &Statistics::std, &Statistics::sse}) {
      const double expected = evo.statistics.*member;
      const bool relative = member == &Statistics::sse || evo.relation == "distance_percent";
      const double scale = relative ? std::max(1.0, expected) : 1.0;
      EXPECT_NEAR(ours.*member, expected, kTolerance * scale);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Data, EvoAgreement,
                         testing::Values("kitti_ORB", "kitti_SPTAM", "fr2_desk", "fr1_xyz",
                                         "fr1_drift", "v102", "georeferenced"),
                         [](const auto& tested) { return std::string(tested.param); });

// Stored by evo's authors beside the data (orb_ape.zip, sptam_ape.zip, orb_rpe.zip).
TEST(EvoPublished, StoredStatistics) {
  if (!std::filesystem::exists(test::evo_data("KITTI_00_gt.txt"))) {
    GTEST_SKIP() << "evo's test data are not at hand";
  }
  const auto rmse_aligned = [](AssociatedTrajectories pairs) {
    pairs.estimate = aligned(pairs.estimate, find_alignment(pairs, AlignmentMethod::rigid));
    return statistics_of(absolute_errors(pairs, Relation::translation)).rmse;
  };
  const AssociatedTrajectories orb = read_pairs("kitti_ORB");
  EXPECT_NEAR(rmse_aligned(orb), 1.3034497145650266, 1e-6);
  EXPECT_NEAR(rmse_aligned(read_pairs("kitti_SPTAM")), 3.738487907582613, 1e-6);
  const std::vector<IndexPair> stretches =
      find_pairs(orb.estimate, {.delta = 10.0, .unit = DeltaUnit::metres});
  EXPECT_NEAR(statistics_of(relative_errors(orb, stretches, Relation::translation)).rmse,
              0.22626134329310163, 1e-6);
}

}  // namespace
}  // namespace surefoot::evaluation
