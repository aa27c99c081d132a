// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/run_yaml.hpp"

#include <filesystem>
#include <fstream>

#include "io/recording.hpp"
#include "runs/config_file.hpp"
#include "support/scratch.hpp"

namespace surefoot::runs {
namespace {

using RunYaml = test::Scratch;

RunDescription some_run() {
  RunDescription run;
  run.version = "1.2";
  run.command = "map";
  run.method = "paper";
  run.input = "/recordings/a: b";
  run.content = "folder of 2 PCD files";
  run.notes = {"a note", "another: \"quoted\"\nin two lines"};
  run.options = {{"start", "3"}, {"stamps", "/a b/times.txt"}, {"no-map", "true"}};
  run.scans = "2";
  run.untrusted = "1";
  run.interrupted = "true";
  run.level = "level: from the ground";
  run.pose_of = "base";
  run.processor = "some";
  run.cores = "4";
  run.threads = "2";
  run.compiler = "12";
  run.parameters = parameter_texts(method_config("paper"));
  return run;
}

TEST_F(RunYaml, WhatIsWrittenIsReadBack) {
  const RunDescription run = some_run();
  write_run_yaml(folder_ / "run.yaml", run);
  const RunDescription read = read_run_yaml(folder_ / "run.yaml");
  EXPECT_EQ(read.version, run.version);
  EXPECT_EQ(read.command, run.command);
  EXPECT_EQ(read.method, run.method);
  EXPECT_EQ(read.input, run.input);
  EXPECT_EQ(read.content, run.content);
  EXPECT_EQ(read.notes, run.notes);
  EXPECT_EQ(read.options, run.options);
  EXPECT_EQ(read.scans, run.scans);
  EXPECT_EQ(read.untrusted, run.untrusted);
  EXPECT_EQ(read.interrupted, run.interrupted);
  EXPECT_EQ(read.level, run.level);
  EXPECT_EQ(read.pose_of, run.pose_of);
  EXPECT_EQ(read.processor, run.processor);
  EXPECT_EQ(read.cores, run.cores);
  EXPECT_EQ(read.threads, run.threads);
  EXPECT_EQ(read.compiler, run.compiler);
  EXPECT_EQ(read.parameters, run.parameters);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "run.yaml.surefoot-part"));
}

/// Names of files are bytes; what is UTF-8 among them stays legible.
TEST_F(RunYaml, PathsThatAreNoTextAreReadBack) {
  RunDescription run = some_run();
  run.input = "/recordings/gar\xe7on/\xff\xfe";
  run.notes = {"/a/\xc3\xa9t\xc3\xa9: a note", "cut short: \xe2\x82", "overlong: \xc0\xaf"};
  run.options = {{"stamps", "/\xed\xa0\x80/times.txt"}, {"calibration", "/\xf0\x9f\xa4\x96.xml"}};
  write_run_yaml(folder_ / "run.yaml", run);
  const RunDescription read = read_run_yaml(folder_ / "run.yaml");
  EXPECT_EQ(read.input, run.input);
  EXPECT_EQ(read.notes, run.notes);
  EXPECT_EQ(read.options, run.options);
  Config config = method_config("paper");
  load_config_file(folder_ / "run.yaml", config);
  EXPECT_EQ(parameter_texts(config), run.parameters);
  const std::string text = run_yaml_text(run);
  EXPECT_NE(text.find("/a/\xc3\xa9t\xc3\xa9: a note"), std::string::npos) << text;
  EXPECT_NE(text.find("/\xf0\x9f\xa4\x96.xml"), std::string::npos) << text;
}

TEST_F(RunYaml, BinaryThatIsNoneIsRefused) {
  std::ofstream(folder_ / "run.yaml") << "input:\n  path: !!binary \"?\"\n";
  EXPECT_THROW((void)read_run_yaml(folder_ / "run.yaml"), io::ReadError);
}

TEST_F(RunYaml, IsTakenAsConfiguration) {
  Config used = method_config("paper");
  set_parameter(used, "deskew.segments", "6");
  RunDescription run = some_run();
  run.parameters = parameter_texts(used);
  write_run_yaml(folder_ / "run.yaml", run);
  EXPECT_EQ(method_of_file(folder_ / "run.yaml"), "paper");
  Config config = method_config("paper");
  load_config_file(folder_ / "run.yaml", config);
  EXPECT_EQ(parameter_texts(config), parameter_texts(used));
}

TEST_F(RunYaml, EntriesMayBeMissingButNotBeNonsense) {
  EXPECT_EQ(read_run_yaml(write("run.yaml", "method: icp\n")).method, "icp");
  EXPECT_TRUE(read_run_yaml(write("run.yaml", "")).method.empty());
  EXPECT_TRUE(
      read_run_yaml(write("run.yaml", "input: 3\noptions: [1]\nmethod: {}\n")).method.empty());
  EXPECT_THROW((void)read_run_yaml(write("run.yaml", "- 1\n")), io::ReadError);
  EXPECT_THROW((void)read_run_yaml(write("run.yaml", "a: [1\n")), io::ReadError);
  EXPECT_THROW((void)read_run_yaml(folder_ / "none.yaml"), io::ReadError);
}

}  // namespace
}  // namespace surefoot::runs
