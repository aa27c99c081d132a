// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "experiments/compare_inputs.hpp"

#include "experiments/compare_results.hpp"
#include "simulation/standard_suite.hpp"
#include "support/scratch.hpp"

namespace surefoot::experiments {
namespace {

namespace fs = std::filesystem;

using CompareInputs = test::Scratch;
using Names = std::vector<std::string>;

TEST(FolderNames, AreUniqueAndFitForEveryFileSystem) {
  EXPECT_EQ(folder_names({"/a/hall", "/a/yard"}), (Names{"hall", "yard"}));
  EXPECT_EQ(folder_names({"/a/hall", "/b/hall"}), (Names{"a-hall", "b-hall"}));
  EXPECT_EQ(folder_names({"/a/x/hall", "/b/x/hall"}), (Names{"x-hall", "x-hall-2"}));
  EXPECT_EQ(folder_names({"/a/big hall", "/a/..."}), (Names{"big_hall", "_..."}));
  EXPECT_EQ(shown_names({"/a/big hall", "/a/Höhe (2).bag", "/b/x\ny"}),
            (Names{"big hall", "Höhe (2).bag", "x?y"}));
  EXPECT_EQ(shown_names({"/a 1/hall", "/b 2/hall"}), (Names{"a 1-hall", "b 2-hall"}));
  EXPECT_EQ(folder_name("paper+deskew.segments=8"), "paper+deskew.segments=8");
  EXPECT_EQ(folder_name("a/b\n"), "a_b_");
  EXPECT_EQ(folder_name(""), "_");
}

TEST_F(CompareInputs, TruthsAreReadInEveryFormThatHasStampsAndRotations) {
  const auto poses_of = [&](const std::string& content) {
    CompareInput input;
    input.truth = write("truth.txt", content);
    return read_truth(input);
  };
  const Trajectory tum = poses_of("1.5 1 2 3 0 0 0 1\n1.6 4 2 3 0 0 0 1\n");
  const Trajectory nine = poses_of("1 500000000 1 2 3 0 0 0 1\n1 600000000 4 2 3 0 0 0 1\n");
  ASSERT_EQ(nine.size(), tum.size());
  for (std::size_t i = 0; i < tum.size(); ++i) {
    EXPECT_EQ(nine[i].stamp_ns, tum[i].stamp_ns);
    EXPECT_EQ(nine[i].pose.translation, tum[i].pose.translation);
  }
  EXPECT_ANY_THROW((void)poses_of("1.5 1 2 3\n1.6 4 2 3\n"));
}

TEST_F(CompareInputs, TruthLiesBesideTheScansOrIsGiven) {
  write("walk/gt.tum", "");
  write("drive.pcap", "");
  const fs::path other = write("other.tum", "");
  CompareOptions options;
  options.recordings = {folder_ / "walk/", folder_ / "drive.pcap"};
  std::vector<CompareInput> inputs = find_inputs(options);
  ASSERT_EQ(inputs.size(), 2U);
  EXPECT_EQ(inputs[0].name, "walk");
  EXPECT_EQ(inputs[0].truth, folder_ / "walk/gt.tum");
  EXPECT_EQ(inputs[1].name, "drive.pcap");
  EXPECT_EQ(inputs[1].truth, folder_ / "gt.tum");
  options.truths = {other, folder_ / "walk/gt.tum"};
  inputs = find_inputs(options);
  EXPECT_EQ(inputs[0].truth, other);
}

TEST_F(CompareInputs, ASuiteIsEveryFolderWithATruth) {
  for (const char* file : {"s/b/gt.tum", "s/a/gt.tum", "s/no_truth/times.txt", "s/suite.log"}) {
    write(file, "");
  }
  CompareOptions options;
  options.suites = {(folder_ / "s").string()};
  const std::vector<CompareInput> inputs = find_inputs(options);
  ASSERT_EQ(inputs.size(), 2U);
  EXPECT_EQ(inputs[0].name, "a");
  EXPECT_EQ(inputs[1].name, "b");
}

TEST_F(CompareInputs, OfASetThatIsNotMadeYetTheNamesAreKnown) {
  CompareOptions options;
  options.output = folder_ / "out";
  options.suites = {"reporting"};
  const std::vector<CompareInput> planned = find_inputs(options);
  ASSERT_EQ(planned.size(), simulation::find_suite_set("reporting")->entries().size());
  EXPECT_EQ(planned[0].name, "campus-handheld");
  EXPECT_FALSE(fs::exists(options.output));
  const fs::path folder = planned[0].path.parent_path().lexically_relative(folder_);
  write((folder / "complete").string(), "");
  write((folder / "campus-handheld/gt.tum").string(), "");
  const std::vector<CompareInput> made = find_inputs(options);
  ASSERT_EQ(made.size(), 1U) << "what is there goes before the table";
  EXPECT_EQ(made[0].path, planned[0].path);
}

TEST_F(CompareInputs, SeveralSuitesKeepTheirRecordingsApart) {
  for (const char* file : {"one/walk/gt.tum", "one/run/gt.tum", "two/walk/gt.tum"}) write(file, "");
  CompareOptions options;
  options.suites = {(folder_ / "one").string(), (folder_ / "two").string()};
  Names names;
  for (const CompareInput& input : find_inputs(options)) names.push_back(input.name);
  EXPECT_EQ(names, (Names{"run", "one-walk", "two-walk"}));
}

TEST_F(CompareInputs, NonsenseIsRefused) {
  write("walk/gt.tum", "");
  const fs::path walk = folder_ / "walk";
  const auto expect_refused = [](const CompareOptions& options, const std::string& named) {
    try {
      (void)find_inputs(options);
      ADD_FAILURE() << "taken; expected " << named;
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find(named), std::string::npos) << error.what();
    }
  };
  const auto with = [](std::vector<fs::path> recordings, std::vector<fs::path> truths,
                       const std::string& suite) {
    CompareOptions options;
    options.recordings = std::move(recordings);
    options.truths = std::move(truths);
    if (!suite.empty()) options.suites = {suite};
    return options;
  };
  expect_refused(with({}, {}, ""), "nothing to compare");
  expect_refused(with({folder_ / "none"}, {}, ""), "none: no such");
  expect_refused(with({walk}, {walk, walk}, ""), "2 files for 1");
  expect_refused(with({walk}, {folder_ / "none.tum"}, ""), "none.tum");
  expect_refused(with({walk, folder_ / "." / "walk"}, {}, ""), "given twice");
  expect_refused(with({}, {}, "nightly"), "tuning, reporting");
  expect_refused(with({}, {}, walk.string()), "gt.tum");
}

}  // namespace
}  // namespace surefoot::experiments
