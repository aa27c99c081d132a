// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Command lines and configuration files that are wrong: exit code 2, a message that says what is
// wrong, and no results.
#include <gtest/gtest.h>

#include "process.hpp"
#include "recordings.hpp"

namespace surefoot::test {
namespace {

struct BadUsage {
  const char* name;
  std::vector<std::string> arguments;
  std::vector<std::string> named;  ///< what the message must hold
};

void PrintTo(const BadUsage& usage, std::ostream* out) { *out << usage.name; }

const BadUsage kBadCommands[] = {
    {"nothing", {}, {"subcommand"}},
    {"unknown_command", {"walk"}, {"subcommand"}},
    {"unknown_flag_of_all", {"--foo"}, {"--foo"}},
    {"unknown_flag", {"run", "in", "--fly"}, {"--fly"}},
    {"no_input", {"run"}, {"input"}},
    {"two_inputs", {"run", "in", "in"}, {"in"}},
    {"unknown_method", {"run", "in", "--method", "magic"}, {"magic", "paper"}},
    {"no_threads", {"run", "in", "--threads", "0"}, {"--threads", "0"}},
    {"threads_not_a_number", {"run", "in", "--threads", "many"}, {"--threads", "many"}},
    {"no_scans_wanted", {"run", "in", "--count", "0"}, {"--count"}},
    {"no_stride", {"run", "in", "--stride", "0"}, {"--stride"}},
    {"negative_start", {"run", "in", "--start", "-1"}, {"--start", "'-1'", "at least 0"}},
    {"start_wraps_to_zero", {"run", "in", "--start=-18446744073709551616"}, {"--start"}},
    {"start_a_fraction", {"run", "in", "--start", "1.5"}, {"--start", "'1.5'"}},
    {"start_too_large", {"run", "in", "--start", "18446744073709551616"}, {"--start"}},
    {"negative_count", {"run", "in", "--count", "-1"}, {"--count", "'-1'", "at least 1"}},
    {"negative_stride", {"run", "in", "--stride", "-1"}, {"--stride", "'-1'", "at least 1"}},
    {"unknown_level", {"run", "in", "--level", "sky"}, {"--level", "sky"}},
    // What takes a list takes one word: the input that follows is none of it.
    {"extrinsic_then_input", {"run", "--extrinsic", "0,0,0.3,0,10,0", "none"}, {"none", "no such"}},
    {"extrinsic_in_words_then_input",
     {"run", "--extrinsic", "0", "0", "0.3", "0", "10", "0", "none"},
     {"none", "no such"}},
    {"methods_then_input", {"compare", "--methods", "paper,icp", "none"}, {"none", "no such"}},
    {"segments_then_input", {"eval", "--segments", "10,20", "none", "none"}, {"none"}},
    {"tiles_at_then_map",
     {"export", "--tiles", "t", "--tiles-at", "48.1,11.6,520,90", "none"},
     {"none"}},
    {"short_extrinsic", {"run", "in", "--extrinsic", "0", "0", "1"}, {"--extrinsic"}},
    {"base_without_extrinsic", {"run", "in", "--pose-of", "base"}, {"--extrinsic"}},
    {"level_and_extrinsic",
     {"run", "in", "--level", "none", "--extrinsic", "0", "0", "0", "0", "0", "0"},
     {"--level", "--extrinsic"}},
    {"map_voxel_zero", {"run", "in", "--map-voxel", "0"}, {"--map-voxel"}},
    {"map_voxel_of_no_map",
     {"run", "in", "--map-voxel", "0.2", "--no-map"},
     {"--map-voxel", "--no-map"}},
    {"level_beside_extrinsic",
     {"run", "in", "--extrinsic", "0,0,0.3,0,0,0", "--set", "level.mode=ground"},
     {"level.mode=ground", "--extrinsic"}},
    {"level_twice",
     {"run", "in", "--level", "none", "--set", "level.mode=ground"},
     {"level.mode=ground", "--level"}},
    {"loops_and_no_loops", {"map", "in", "--no-loops", "--loop-closure"}, {"--no-loops"}},
    {"frame_below_zero", {"export", "in", "--frame", "-1"}, {"--frame", "'-1'"}},
    {"mesh_cell_of_no_mesh", {"export", "in", "--mesh-cell", "1"}, {"--mesh-cell", "--mesh"}},
    {"nowhere_on_earth",
     {"export", "in", "--tiles", "t", "--tiles-at", "91,2,3,4"},
     {"--tiles-at", "91 2 3 4"}},
    {"rate_zero", {"run", "in", "--rate", "0"}, {"--rate"}},
    {"unknown_unit", {"run", "in", "--time-unit", "fortnights"}, {"--time-unit", "fortnights"}},
    {"unknown_format", {"run", "in", "--format", "e57"}, {"--format", "e57"}},
    {"port_too_large", {"run", "in", "--udp-port", "70000"}, {"--udp-port", "70000"}},
    {"negative_port", {"info", "in", "--udp-port", "-1"}, {"--udp-port", "-1"}},
    {"negative_poses", {"eval", "a", "b", "--align-poses", "-1"}, {"--align-poses", "'-1'"}},
    {"negative_sweep_count",
     {"sweep", "in", "--vary", "map.voxel_size=1", "--count", "-1"},
     {"--count", "'-1'"}},
    {"negative_sweep_jobs",
     {"sweep", "in", "--vary", "map.voxel_size=1", "--jobs", "-1"},
     {"--jobs", "-1"}},
    {"compare_nothing", {"compare"}, {"nothing to compare"}},
    {"compare_truth_takes_all",
     {"compare", "--truth", "a_file", "in"},
     {"nothing to compare", "before --truth"}},
    {"compare_before_a_suite_is_made",
     {"compare", "none", "--suite", "tuning"},
     {"none", "no such"}},
    {"compare_no_such_recording", {"compare", "none"}, {"none", "no such"}},
    {"compare_twice", {"compare", "in", "in"}, {"in", "twice"}},
    {"compare_unknown_method", {"compare", "in", "--methods", "magic"}, {"magic", "paper"}},
    {"compare_method_twice", {"compare", "in", "--methods", "paper,paper"}, {"paper", "twice"}},
    {"compare_bad_variant",
     {"compare", "in", "--methods", "paper+deskew.segments"},
     {"deskew.segments", "key=value"}},
    {"compare_bad_value",
     {"compare", "in", "--methods", "paper+deskew.segments=0"},
     {"deskew.segments", "0", "1"}},
    {"compare_bad_setting", {"compare", "in", "--set", "deskew.speed=1"}, {"deskew.speed"}},
    {"compare_no_repeats", {"compare", "in", "--repeat", "0"}, {"--repeat"}},
    {"compare_no_jobs", {"compare", "in", "-j", "0"}, {"--jobs"}},
    {"compare_negative_count", {"compare", "in", "--count", "-1"}, {"--count", "'-1'"}},
    {"compare_truths", {"compare", "in", "--truth", "a_file", "a_file"}, {"--truth", "2 files"}},
    {"compare_no_such_truth", {"compare", "in", "--truth", "none.tum"}, {"none.tum"}},
    {"compare_unknown_suite", {"compare", "--suite", "nightly"}, {"nightly", "tuning"}},
    {"compare_empty_suite", {"compare", "--suite", "in"}, {"gt.tum"}},
    {"compare_alignment", {"compare", "in", "--align", "upwards"}, {"upwards"}},
    {"compare_coverage", {"compare", "in", "--full-coverage", "1.5"}, {"--full-coverage"}},
    {"ablate_nothing", {"ablate"}, {"nothing to compare"}},
    {"ablate_unknown_method",
     {"ablate", "in", "--method", "magic"},
     {"magic", "paper", "surefoot"}},
    {"ablate_method_without_a_plan", {"ablate", "in", "--method", "icp"}, {"icp", "paper"}},
    {"ablate_no_such_recording", {"ablate", "none"}, {"none", "no such"}},
    {"ablate_no_truth", {"ablate", "in"}, {"gt.tum"}},
    {"ablate_bad_setting", {"ablate", "in", "--set", "deskew.speed=1"}, {"deskew.speed"}},
    {"ablate_negative_count", {"ablate", "in", "--count", "-1"}, {"--count", "'-1'"}},
    {"ablate_unknown_suite", {"ablate", "--suite", "nightly"}, {"nightly", "reporting-2"}},
    {"set_unknown_key", {"run", "in", "--set", "deskew.speed=1"}, {"deskew.speed"}},
    {"set_of_another_method",
     {"run", "in", "--set", "deskew.segments=8"},
     {"deskew.segments", "surefoot", "paper"}},
    {"variant_of_another_method",
     {"compare", "in", "--methods", "icp+knots.segments=4"},
     {"knots.segments", "icp", "surefoot"}},
    {"set_without_value", {"run", "in", "--set", "deskew.segments"}, {"key=value"}},
    {"set_not_a_number",
     {"run", "in", "--set", "deskew.segments=four"},
     {"deskew.segments", "four"}},
    {"set_fraction", {"run", "in", "--set", "deskew.segments=1.5"}, {"deskew.segments", "1.5"}},
    {"set_out_of_range",
     {"run", "in", "--set", "deskew.segments=0"},
     {"deskew.segments", "0", "1"}},
    {"set_nan", {"run", "in", "--set", "map.voxel_size=nan"}, {"map.voxel_size", "nan"}},
    {"set_inf", {"run", "in", "--set", "map.voxel_size=inf"}, {"map.voxel_size", "inf"}},
    {"set_empty", {"run", "in", "--set", "map.voxel_size="}, {"map.voxel_size"}},
    {"set_trailing", {"run", "in", "--set", "map.voxel_size=1m"}, {"map.voxel_size", "1m"}},
    {"set_unknown_word", {"run", "in", "--set", "deskew.mode=magic"}, {"deskew.mode", "magic"}},
    {"config_missing", {"run", "in", "--config", "none.yaml"}, {"none.yaml"}},
    {"config_is_a_folder", {"run", "in", "--config", "in"}, {"in"}},
    {"output_is_a_file", {"run", "in", "-o", "a_file"}, {"a_file"}},
    {"output_under_a_file", {"run", "in", "-o", "a_file/out"}, {"a_file/out"}},
};

#ifdef SUREFOOT_HAS_SIMULATION
const BadUsage kBadSimulations[] = {
    {"tilt_then_scene", {"simulate", "-o", "out", "--tilt", "0,-5,0", "moon"}, {"moon"}},
    {"mount_then_scene", {"simulate", "-o", "out", "--mount", "0", "0", "0.1", "moon"}, {"moon"}},
    {"format_then_scene", {"simulate", "-o", "out", "--format", "pcd,pcap", "moon"}, {"moon"}},
    {"negative_seed", {"simulate", "campus", "-o", "out", "--seed", "-1"}, {"--seed", "'-1'"}},
    {"negative_scans", {"simulate", "campus", "-o", "out", "--scans", "-1"}, {"--scans", "-1"}},
    {"too_much_rain", {"simulate", "campus", "-o", "out", "--rain", "0.9"}, {"--rain", "0.9"}},
    {"negative_people", {"simulate", "campus", "-o", "out", "--people", "-1"}, {"--people", "-1"}},
    {"unknown_scene", {"simulate", "moon", "-o", "out"}, {"moon"}},
    {"no_output", {"simulate", "campus"}, {"-o"}},
    {"negative_jobs", {"suite", "-o", "out", "--jobs", "-1"}, {"--jobs", "-1"}},
    {"no_suite_output", {"suite"}, {"--output"}},
    {"unknown_seeds", {"suite", "-o", "out", "--seeds", "lucky"}, {"lucky", "reporting-3"}},
};
#endif

const BadUsage kBadConfigs[] = {
    {"not_yaml", {"deskew: [1, 2"}, {"not YAML"}},
    {"binary", {std::string("\x01\x02\xff\xfe\0", 5)}, {}},
    {"unknown_key", {"deskew: {segmnts: 4}"}, {"deskew.segmnts"}},
    {"unknown_group", {"deskewing: {segments: 4}"}, {"deskewing.segments"}},
    {"out_of_range", {"deskew: {segments: 1000000}"}, {"deskew.segments", "1000000"}},
    {"not_a_number", {"map: {voxel_size: big}"}, {"map.voxel_size", "big"}},
    {"of_another_method", {"deskew: {segments: 8}"}, {"deskew.segments", "paper"}},
    {"key_twice", {"knots: {segments: 4, segments: 5}"}, {"knots.segments", "twice"}},
    {"zeros", {std::string(64, '\0')}, {"not YAML"}},
    {"no_value", {"map: {voxel_size: }"}, {"map.voxel_size"}},
    {"a_list", {"- 1\n- 2\n"}, {"map"}},
    {"list_as_value", {"map: {voxel_size: [1, 2]}"}, {"map.voxel_size"}},
    {"only_a_word", {"hello"}, {"map"}},
    {"list_as_key", {"? [1, 2]\n: 3\n"}, {}},
    {"deep", {std::string(100'000, '[')}, {}},
};

void expect_refused(const std::vector<std::string>& arguments,
                    const std::vector<std::string>& named, const ScratchFolder& scratch) {
  const ProcessResult result = run_surefoot(arguments, scratch.path());
  EXPECT_EQ(result.exit_code, 2) << result;
  EXPECT_FALSE(result.errors.empty()) << result;
  for (const std::string& word : named) {
    EXPECT_NE(result.errors.find(word), std::string::npos) << "not named: " << word << "\n"
                                                           << result;
  }
  EXPECT_FALSE(std::filesystem::exists(scratch.path() / "out")) << result;
  EXPECT_FALSE(std::filesystem::exists(scratch.path() / "results")) << result;
}

class BadCommand : public testing::TestWithParam<BadUsage> {};

TEST_P(BadCommand, IsRefused) {
  const ScratchFolder scratch;
  write_pcd_recording(scratch.path() / "in", hall_scans(1));
  write_content(scratch.path() / "a_file", "");
  expect_refused(GetParam().arguments, GetParam().named, scratch);
}

INSTANTIATE_TEST_SUITE_P(All, BadCommand, testing::ValuesIn(kBadCommands),
                         [](const auto& instance) { return std::string(instance.param.name); });

#ifdef SUREFOOT_HAS_SIMULATION
INSTANTIATE_TEST_SUITE_P(Simulation, BadCommand, testing::ValuesIn(kBadSimulations),
                         [](const auto& instance) { return std::string(instance.param.name); });
#endif

class BadConfig : public testing::TestWithParam<BadUsage> {};

TEST_P(BadConfig, IsRefused) {
  const ScratchFolder scratch;
  write_pcd_recording(scratch.path() / "in", hall_scans(1));
  write_content(scratch.path() / "bad.yaml", GetParam().arguments.front());
  std::vector<std::string> named = GetParam().named;
  named.push_back("bad.yaml");
  expect_refused({"run", "in", "-o", "out", "--config", "bad.yaml"}, named, scratch);
}

INSTANTIATE_TEST_SUITE_P(All, BadConfig, testing::ValuesIn(kBadConfigs),
                         [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace surefoot::test
