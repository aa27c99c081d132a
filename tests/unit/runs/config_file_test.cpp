// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/config_file.hpp"

#include "runs/run_options.hpp"
#include "support/scratch.hpp"

namespace surefoot::runs {
namespace {

using ConfigFile = test::Scratch;

TEST_F(ConfigFile, NestedAndDottedKeysAreTheSame) {
  Config nested, dotted;
  load_config_file(write("nested.yaml", "knots: {segments: 7}\n"), nested);
  load_config_file(write("dotted.yaml", "knots.segments: 7\n"), dotted);
  EXPECT_EQ(get_parameter(nested, "knots.segments"), "7");
  EXPECT_EQ(get_parameter(dotted, "knots.segments"), "7");
  Config empty;
  EXPECT_NO_THROW(load_config_file(write("empty.yaml", "# nothing\n"), empty));
}

TEST_F(ConfigFile, WhatIsWrongIsNamedWithItsFile) {
  const std::pair<std::string, std::string> cases[] = {
      {"deskew: {segments: 4}\ndeskew: {segments: 5}\n", "line 2: deskew stands there twice"},
      {"deskew: {segments: 4, segments: 5}\n", "deskew.segments stands there twice"},
      {"deskew: {segments: 4}\ndeskew.segments: 5\n", "line 2: deskew.segments stands there twice"},
      {"method: icp\nmethod: paper\n", "line 2: method stands there twice"},
      {"deskew: {segments: 8}\n", "method surefoot does not read it; what reads it: paper"},
      {std::string("\0\0\0\0", 4), "byte 0x00 at 0"},
      {"\x7f"
       "ELF",
       "byte 0x7f at 0"},
      {"deskew: {segments: 4}\n\x01", "byte 0x01"},
      {std::string(2 << 20, ' '), "too long"}};
  for (const auto& [content, named] : cases) {
    const auto file = write("bad.yaml", content);
    try {
      Config config;
      (void)method_of_file(file);
      load_config_file(file, config);
      ADD_FAILURE() << "taken: " << content.substr(0, 80);
    } catch (const ConfigError& error) {
      EXPECT_NE(std::string(error.what()).find(named), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("bad.yaml"), std::string::npos) << error.what();
    }
  }
}

TEST_F(ConfigFile, IsOfTheMethodThatIsAskedFor) {
  RunOptions options;
  options.config_file =
      write("run.yaml", "method: icp\nparameters: {preprocess: {max_range: 70}}\n");
  EXPECT_EQ(method_of(options), "icp");
  options.method = "icp";
  EXPECT_EQ(get_parameter(config_of(options), "preprocess.max_range"), "70");
  options.method = "paper";
  try {
    (void)config_of(options);
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_NE(std::string(error.what())
                  .find("run.yaml: its parameters are of method icp, and "
                        "--method says paper"),
              std::string::npos)
        << error.what();
  }
  options.config_file = write("common.yaml", "preprocess: {max_range: 70}\n");  // of any method
  EXPECT_EQ(method_of(options), "paper");
  options.config_file = write("empty.yaml", "method:\npreprocess: {max_range: 70}\n");
  EXPECT_EQ(method_of(options), "paper");
  EXPECT_EQ(get_parameter(config_of(options), "preprocess.max_range"), "70");
}

}  // namespace
}  // namespace surefoot::runs
