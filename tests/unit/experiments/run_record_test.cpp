// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "experiments/run_record.hpp"

#include "support/scratch.hpp"

namespace surefoot::experiments {
namespace {

using RunRecordTest = test::Scratch;

const CompareInput kInput{"walk", "/r/walk", "/r/walk/gt.tum", {"0123", 7}};

std::string key_of(const CompareInput& input, const std::string& variant,
                   const std::vector<std::string>& arguments, const std::string& build) {
  const MethodVariant parsed = parse_variant(variant);
  return run_key(input, parsed, variant_config(parsed, {}), arguments, build);
}

TEST(RunKey, ChangesWithWhatDecidesTheResult) {
  const std::string key = key_of(kInput, "paper", {"--count", "5"}, "b");
  EXPECT_EQ(key, key_of(kInput, "paper", {"--count", "5"}, "b"));
  EXPECT_EQ(key,
            key_of(kInput, "paper+deskew.segments=" + get_parameter(Config(), "deskew.segments"),
                   {"--count", "5"}, "b"))
      << "the parameters as used count, not how they were asked for";
  CompareInput changed = kInput;
  changed.mark.fingerprint = "4567";
  CompareInput elsewhere = kInput;
  elsewhere.path = "/other/walk";
  for (const std::string& other : {key_of(changed, "paper", {"--count", "5"}, "b"),
                                   key_of(elsewhere, "paper", {"--count", "5"}, "b"),
                                   key_of(kInput, "paper-cv", {"--count", "5"}, "b"),
                                   key_of(kInput, "paper+map.radius=50", {"--count", "5"}, "b"),
                                   key_of(kInput, "paper", {"--count", "6"}, "b"),
                                   key_of(kInput, "paper", {"--count", "5"}, "c")}) {
    EXPECT_NE(key, other);
  }
}

TEST_F(RunRecordTest, TheKeyChangesWithFilesThatArgumentsName) {
  const std::string file = write("stamps.txt", "0\n").string();
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"--stamps=" + file}, {"--stamps", file}}) {
    write("stamps.txt", "0\n");
    const std::string key = key_of(kInput, "paper", arguments, "b");
    EXPECT_EQ(key, key_of(kInput, "paper", arguments, "b"));
    write("stamps.txt", "0\n1\n");
    EXPECT_NE(key, key_of(kInput, "paper", arguments, "b"));
  }
}

TEST_F(RunRecordTest, TheKeyChangesWithTheMapInAFolderThatIsNamed) {
  const std::vector<std::string> arguments = {"--localize=" + folder_.string()};
  write("map.surefoot", "a map");
  const std::string key = key_of(kInput, "paper", arguments, "b");
  write("map.surefoot", "another map");
  EXPECT_NE(key, key_of(kInput, "paper", arguments, "b"));
}

TEST_F(RunRecordTest, IsReadBack) {
  const RunRecord record{key_of(kInput, "paper", {}, "b"), {0, 0, 1.5, 1.25, 4096}, 2};
  write_record(folder_, record);
  const std::optional<RunRecord> read = read_record(folder_);
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->key, record.key);
  EXPECT_EQ(read->end.exit_code, 0);
  EXPECT_EQ(read->end.wall_seconds, 1.5);
  EXPECT_EQ(read->end.peak_memory_bytes, 4096U);
  EXPECT_EQ(read->jobs, 2);
}

TEST_F(RunRecordTest, WhatIsNoRecordIsNone) {
  EXPECT_FALSE(read_record(folder_).has_value());
  for (const char* content : {"", "{", "[]", "{}", "{\"key\": {}, \"exit_code\": \"zero\"}"}) {
    write("compare_run.json", content);
    EXPECT_FALSE(read_record(folder_).has_value()) << content;
  }
}

TEST_F(RunRecordTest, ForeignFilesAreNeverRemoved) {
  const auto thesis = write("run/thesis.tex", "years of work");
  EXPECT_THROW(clear_run_folder(folder_ / "run"), std::runtime_error);
  EXPECT_TRUE(std::filesystem::exists(thesis));
  write("run/run.log", "");
  clear_run_folder(folder_ / "run");
  EXPECT_TRUE(std::filesystem::is_empty(folder_ / "run"));
  EXPECT_NO_THROW(clear_run_folder(folder_ / "run"));
  EXPECT_NO_THROW(clear_run_folder(folder_ / "new"));
}

TEST_F(RunRecordTest, AFailureIsToldWithTheLogsLastWords) {
  write("run.log", "reading\nsurefoot: 000003.pcd: no points\n\n");
  const evaluation::MeasuredRun run = measured_run(folder_, {"{}", {2, 0, 1.0, 1.0, 4096}, 1});
  EXPECT_EQ(run.error, "ended with exit code 2: surefoot: 000003.pcd: no points");
  EXPECT_EQ(run.scans, 0U);
  const evaluation::MeasuredRun killed = measured_run(folder_, {"{}", {-1, 9, 1.0, 1.0, 4096}, 1});
  EXPECT_NE(killed.error.find("signal 9"), std::string::npos) << killed.error;
  EXPECT_NE(killed.error.find("out of memory"), std::string::npos) << killed.error;
}

/// What follows an error is no reason.
TEST_F(RunRecordTest, TheReasonIsTheProgramsLastError) {
  const auto error_of = [&](const std::string& log) {
    write("run.log", log);
    return measured_run(folder_, {"{}", {2, 0, 1.0, 1.0, 4096}, 1}).error;
  };
  const std::string ended = "ended with exit code 2: ";
  EXPECT_EQ(error_of("surefoot: walk.bag: several topics hold scans; choose one:\n"
                     "  --topic /points\n  --topic /surefoot/local_map\n"),
            ended + "surefoot: walk.bag: several topics hold scans; choose one:");
  EXPECT_EQ(error_of("The following argument was not expected: --pass=--foo\n"
                     "Run with --help for more information.\n"),
            ended + "The following argument was not expected: --pass=--foo");
  EXPECT_EQ(error_of("note: the file is cut short\nsurefoot: walk.db3: no scans\n"
                     "note: the first 3 scans are whole\n"),
            ended + "surefoot: walk.db3: no scans");
  EXPECT_EQ(error_of("reading\nterminate called\n\n"), ended + "terminate called");
}

// It is a line of a list.
TEST_F(RunRecordTest, AReasonIsOneLine) {
  write("run.log", "surefoot: a\vb: no scans\n");
  const evaluation::MeasuredRun run = measured_run(folder_, {"{}", {2, 0, 1.0, 0.5, 4096}, 1});
  EXPECT_EQ(run.error, "ended with exit code 2: surefoot: a?b: no scans");
}

// `surefoot run` says so of a recording with scans that it could not read.
TEST_F(RunRecordTest, ARunThatLeftScansOutIsDone) {
  write("run.log", "left out: 000003.pcd: empty file\n");
  write("scans.csv", "stamp,status,ms_total\n0.05,first_scan,1\n0.15,ok,9\n");
  EXPECT_EQ(measured_run(folder_, {"{}", {1, 0, 1.0, 0.5, 4096}, 1}).error, "");
  write("run.yaml", "surefoot: 0.1.0\nresult:\n  scans: 2\n  unreadable_scans: 1\n");
  const evaluation::MeasuredRun run = measured_run(folder_, {"{}", {1, 0, 1.0, 0.5, 4096}, 1});
  EXPECT_EQ(run.error, "");
  EXPECT_EQ(run.unreadable, 1U);
}

TEST_F(RunRecordTest, AGoodRunIsMeasured) {
  write("scans.csv", "stamp,status,ms_total\n0.05,first_scan,1\n0.15,ok,9\n0.25,ok,3\n0.35,ok,2\n");
  const evaluation::MeasuredRun run = measured_run(folder_, {"{}", {0, 0, 1.0, 0.5, 4096}, 1});
  EXPECT_EQ(run.error, "");
  EXPECT_EQ(run.scans, 4U);
  EXPECT_EQ(run.median_ms, 2.0);
  EXPECT_EQ(run.p99_ms, 9.0);
  EXPECT_EQ(run.statuses.at("ok"), 3U);
}

}  // namespace
}  // namespace surefoot::experiments
