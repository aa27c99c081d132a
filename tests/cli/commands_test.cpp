// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <regex>
#include <string>

#include "io/file_writer.hpp"
#include "process.hpp"
#include "recordings.hpp"

namespace surefoot::test {
namespace {

const char* const kCommands[] = {"run",    "info",   "eval",  "compare",
                                 "ablate", "report", "sweep", "config"};

TEST(Commands, HelpNamesEverySubcommand) {
  const ScratchFolder scratch;
  const ProcessResult result = run_surefoot({"--help"}, scratch.path());
  EXPECT_EQ(result.exit_code, 0) << result;
  for (const char* command : kCommands) {
    EXPECT_NE(result.output.find(std::string("\n  ") + command + " "), std::string::npos)
        << command << "\n"
        << result;
  }
}

TEST(Commands, EverySubcommandHasHelp) {
  const ScratchFolder scratch;
  for (const char* command : kCommands) {
    const ProcessResult result = run_surefoot({command, "--help"}, scratch.path());
    EXPECT_EQ(result.exit_code, 0) << result;
    EXPECT_NE(result.output.find("Options:"), std::string::npos) << result;
    EXPECT_TRUE(result.errors.empty()) << result;
  }
}

TEST(Commands, HelpIsACommandToo) {
  const ScratchFolder scratch;
  for (const std::vector<std::string>& command : {std::vector<std::string>{}, {"run"}, {"eval"}}) {
    std::vector<std::string> asked = {"help"}, flag = command;
    asked.insert(asked.end(), command.begin(), command.end());
    flag.emplace_back("--help");
    const ProcessResult result = run_surefoot(asked, scratch.path());
    EXPECT_EQ(result.exit_code, 0) << result;
    EXPECT_EQ(result.output, run_surefoot(flag, scratch.path()).output);
  }
  const ProcessResult unknown = run_surefoot({"help", "rnu"}, scratch.path());
  EXPECT_EQ(unknown.exit_code, 2) << unknown;
  EXPECT_NE(unknown.errors.find("run"), std::string::npos) << unknown;
}

// And in a checkout the commit, so that a result tells which code it is of.
TEST(Commands, VersionIsTheFileVersion) {
  const ScratchFolder scratch;
  const ProcessResult result = run_surefoot({"--version"}, scratch.path());
  EXPECT_EQ(result.exit_code, 0) << result;
  std::string version = file_content(std::string(SUREFOOT_SOURCE_DIR) + "/VERSION");
  version.pop_back();
  ASSERT_EQ(result.output.substr(0, version.size()), version);
  const std::string more = result.output.substr(version.size());
  EXPECT_TRUE(std::regex_match(more, std::regex(R"((\+[0-9a-f]{7,40}(\.changed)?)?\n)"))) << more;
  const std::string ask = "git -C '" SUREFOOT_SOURCE_DIR "' rev-parse HEAD > /dev/null 2>&1";
  if (std::filesystem::exists(std::string(SUREFOOT_SOURCE_DIR) + "/.git") &&
      std::system(ask.c_str()) == 0) {
    EXPECT_NE(more, "\n");
  }
}

TEST(Commands, ConfigPrintsWhatTheMethodReads) {
  const ScratchFolder scratch;
  for (const char* flag : {"--yaml", "--method"}) {  // the latter as it is anyway
    std::vector<std::string> arguments = {"config", "--method", "icp"};
    if (flag == std::string("--yaml")) arguments.emplace_back(flag);
    const ProcessResult printed = run_surefoot(arguments, scratch.path());
    EXPECT_EQ(printed.exit_code, 0) << printed;
    EXPECT_NE(printed.output.find("icp"), std::string::npos) << printed;
    for (const char* foreign : {"\nknots", "\ndeskew", "\nmap"}) {
      EXPECT_EQ(printed.output.find(foreign), std::string::npos) << printed;
    }
  }
}

TEST(Commands, PrintedConfigIsTakenBack) {
  const ScratchFolder scratch;
  const ProcessResult printed = run_surefoot({"config", "--yaml"}, scratch.path());
  ASSERT_EQ(printed.exit_code, 0) << printed;
  write_content(scratch.path() / "config.yaml", printed.output);
  write_pcd_recording(scratch.path() / "in", hall_scans(2));
  const ProcessResult result =
      run_surefoot({"run", "in", "-o", "out", "--config", "config.yaml"}, scratch.path());
  EXPECT_EQ(result.exit_code, 0) << result;
}

}  // namespace
}  // namespace surefoot::test
