// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "sensors/velodyne/velodyne_model.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <span>

#include "sensors/velodyne/hdl64_calibration.hpp"
#include "sensors/velodyne/vlp16.hpp"

namespace surefoot::sensors {
namespace {

struct Angles {
  double elevation_deg;
  double azimuth_deg;
};

// By laser id. The angles are those of the manuals and of params/ in
// github.com/ros-drivers/velodyne (whose rot_correction is subtracted from the azimuth).
constexpr std::array<Angles, 16> kHiRes = {{{-10.0, 0.0},
                                            {0.667, 0.0},
                                            {-8.667, 0.0},
                                            {2.0, 0.0},
                                            {-7.333, 0.0},
                                            {3.333, 0.0},
                                            {-6.0, 0.0},
                                            {4.667, 0.0},
                                            {-4.667, 0.0},
                                            {6.0, 0.0},
                                            {-3.333, 0.0},
                                            {7.333, 0.0},
                                            {-2.0, 0.0},
                                            {8.667, 0.0},
                                            {-0.667, 0.0},
                                            {10.0, 0.0}}};

constexpr std::array<Angles, 32> kVlp32 = {
    {{-25.0, 1.4},  {-1.0, -4.2},   {-1.667, 1.4}, {-15.639, -1.4}, {-11.31, 1.4}, {0.0, -1.4},
     {-0.667, 4.2}, {-8.843, -1.4}, {-7.254, 1.4}, {0.333, -4.2},   {-0.333, 1.4}, {-6.148, -1.4},
     {-5.333, 4.2}, {1.333, -1.4},  {0.667, 4.2},  {-4.0, -1.4},    {-4.667, 1.4}, {1.667, -4.2},
     {1.0, 1.4},    {-3.667, -4.2}, {-3.333, 4.2}, {3.333, -1.4},   {2.333, 1.4},  {-2.667, -1.4},
     {-3.0, 1.4},   {7.0, -1.4},    {4.667, 1.4},  {-2.333, -4.2},  {-2.0, 4.2},   {15.0, -1.4},
     {10.333, 1.4}, {-1.333, -1.4}}};

constexpr std::array<Angles, 32> kHdl32 = {
    {{-30.67, 0.0}, {-9.33, 0.0}, {-29.33, 0.0}, {-8.0, 0.0}, {-28.0, 0.0}, {-6.67, 0.0},
     {-26.67, 0.0}, {-5.33, 0.0}, {-25.33, 0.0}, {-4.0, 0.0}, {-24.0, 0.0}, {-2.67, 0.0},
     {-22.67, 0.0}, {-1.33, 0.0}, {-21.33, 0.0}, {0.0, 0.0},  {-20.0, 0.0}, {1.33, 0.0},
     {-18.67, 0.0}, {2.67, 0.0},  {-17.33, 0.0}, {4.0, 0.0},  {-16.0, 0.0}, {5.33, 0.0},
     {-14.67, 0.0}, {6.67, 0.0},  {-13.33, 0.0}, {8.0, 0.0},  {-12.0, 0.0}, {9.33, 0.0},
     {-10.67, 0.0}, {10.67, 0.0}}};

constexpr std::array<Angles, 128> kVls128 = {
    {{-11.742, 6.354}, {-1.99, 4.548},  {3.4, 2.732},      {-5.29, 0.911},  {-0.78, -0.911},
     {4.61, -2.732},   {-4.08, -4.548}, {1.31, -6.354},    {-6.5, 6.354},   {-1.11, 4.548},
     {4.28, 2.732},    {-4.41, 0.911},  {0.1, -0.911},     {6.48, -2.732},  {-3.2, -4.548},
     {2.19, -6.354},   {-3.86, 6.354},  {1.53, 4.548},     {-9.244, 2.732}, {-1.77, 0.911},
     {2.74, -0.911},   {-5.95, -2.732}, {-0.56, -4.548},   {4.83, -6.354},  {-2.98, 6.354},
     {2.41, 4.548},    {-6.28, 2.732},  {-0.89, 0.911},    {3.62, -0.911},  {-5.07, -2.732},
     {0.32, -4.548},   {7.58, -6.354},  {-0.34, 6.354},    {5.18, 4.548},   {-3.64, 2.732},
     {1.75, 0.911},    {-25.0, -0.911}, {-2.43, -2.732},   {2.96, -4.548},  {-5.73, -6.354},
     {0.54, 6.354},    {9.7, 4.548},    {-2.76, 2.732},    {2.63, 0.911},   {-7.65, -0.911},
     {-1.55, -2.732},  {3.84, -4.548},  {-4.85, -6.354},   {3.18, 6.354},   {-5.51, 4.548},
     {-0.12, 2.732},   {5.73, 0.911},   {-4.3, -0.911},    {1.09, -2.732},  {-16.042, -4.548},
     {-2.21, -6.354},  {4.06, 6.354},   {-4.63, 4.548},    {0.76, 2.732},   {15.0, 0.911},
     {-3.42, -0.911},  {1.97, -2.732},  {-6.85, -4.548},   {-1.33, -6.354}, {-5.62, 6.354},
     {-0.23, 4.548},   {5.43, 2.732},   {-3.53, 0.911},    {0.98, -0.911},  {-19.582, -2.732},
     {-2.32, -4.548},  {3.07, -6.354},  {-4.74, 6.354},    {0.65, 4.548},   {11.75, 2.732},
     {-2.65, 0.911},   {1.86, -0.911},  {-7.15, -2.732},   {-1.44, -4.548}, {3.95, -6.354},
     {-2.1, 6.354},    {3.29, 4.548},   {-5.4, 2.732},     {-0.01, 0.911},  {4.5, -0.911},
     {-4.19, -2.732},  {1.2, -4.548},   {-13.565, -6.354}, {-1.22, 6.354},  {4.17, 4.548},
     {-4.52, 2.732},   {0.87, 0.911},   {6.08, -0.911},    {-3.31, -2.732}, {2.08, -4.548},
     {-6.65, -6.354},  {1.42, 6.354},   {-10.346, 4.548},  {-1.88, 2.732},  {3.51, 0.911},
     {-6.06, -0.911},  {-0.67, -2.732}, {4.72, -4.548},    {-3.97, -6.354}, {2.3, 6.354},
     {-6.39, 4.548},   {-1.0, 2.732},   {4.39, 0.911},     {-5.18, -0.911}, {0.21, -2.732},
     {6.98, -4.548},   {-3.09, -6.354}, {4.98, 6.354},     {-3.75, 4.548},  {1.64, 2.732},
     {-8.352, 0.911},  {-2.54, -0.911}, {2.85, -2.732},    {-5.84, -4.548}, {-0.45, -6.354},
     {8.43, 6.354},    {-2.87, 4.548},  {2.52, 2.732},     {-6.17, 0.911},  {-1.66, -0.911},
     {3.73, -2.732},   {-4.96, -4.548}, {0.43, -6.354}}};

std::vector<VelodyneLaser> lasers_of(std::span<const Angles> angles) {
  std::vector<VelodyneLaser> lasers;
  for (const Angles& one : angles) {
    VelodyneLaser laser;
    laser.elevation_deg = one.elevation_deg;
    laser.azimuth_deg = one.azimuth_deg;
    lasers.push_back(laser);
  }
  return lasers;
}

// Sixteen lasers fire one after the other, twice a block (manual 63-9243).
VelodyneModel sixteen(const char* name, std::uint8_t product) {
  VelodyneModel model;
  model.name = name;
  model.product = product;
  model.distance_unit = vlp16::kDistanceUnit;
  model.sequences_per_block = 2;
  model.sequence_ns = model.dual_sequence_ns = vlp16::kSequenceNs;
  return model;
}

VelodyneModel vlp16_model() {
  VelodyneModel model = sixteen("VLP-16", vlp16::kProductVlp16);
  for (std::size_t id = 0; id < vlp16::kLasers; ++id) {
    VelodyneLaser laser;
    laser.elevation_deg = vlp16::kElevationDeg[id];
    laser.time_ns = vlp16::kLaserNs * static_cast<double>(id);
    laser.height = 1e-3 * vlp16::kVerticalOffsetMm[id];
    model.lasers.push_back(laser);
  }
  return model;
}

// A sensor's beams cross at one distance from its axis [m], hence their heights on it
// (src/calib_db.cpp of github.com/valgur/velodyne_decoder, after Velodyne's drawings).
void set_heights(double crossing, std::vector<VelodyneLaser>& lasers) {
  for (VelodyneLaser& laser : lasers) {
    laser.height = -crossing * std::tan(laser.elevation_deg * std::numbers::pi / 180.0);
  }
}

VelodyneModel hi_res_model() {
  VelodyneModel model = sixteen("Puck Hi-Res", 0x24);
  model.lasers = lasers_of(kHiRes);
  set_heights(0.04191, model.lasers);
  for (std::size_t id = 0; id < model.lasers.size(); ++id) {
    model.lasers[id].time_ns = vlp16::kLaserNs * static_cast<double>(id);
  }
  return model;
}

// Two lasers fire at a time (manual 63-9325).
VelodyneModel vlp32_model() {
  VelodyneModel model;
  model.name = "VLP-32C";
  model.product = 0x28;
  model.distance_unit = 0.004;
  model.sequence_ns = model.dual_sequence_ns = vlp16::kSequenceNs;
  model.lasers = lasers_of(kVlp32);
  set_heights(0.0424, model.lasers);
  for (std::size_t id = 0; id < model.lasers.size(); ++id) {
    model.lasers[id].time_ns = vlp16::kLaserNs * static_cast<double>(id / 2);
  }
  return model;
}

// One laser after the other (manual 63-9113, appendix on firing sequences).
VelodyneModel hdl32_model() {
  VelodyneModel model;
  model.name = "HDL-32E";
  model.product = 0x21;
  model.distance_unit = 0.002;
  model.sequence_ns = model.dual_sequence_ns = 46'080.0;
  model.lasers = lasers_of(kHdl32);
  set_heights(0.02896, model.lasers);  // which gives the heights in drawing 86-0106 to 0.02 mm
  for (std::size_t id = 0; id < model.lasers.size(); ++id) {
    model.lasers[id].time_ns = 1'152.0 * static_cast<double>(id);
  }
  return model;
}

// The packet's time is that of its end. Both banks fire four lasers 1.2 us apart, eight times; with
// two returns that takes 57.6 us instead of 48 (firing times as in vtkLidarProviderInternal.h of
// VeloView).
VelodyneModel hdl64_model(const char* name, std::vector<VelodyneLaser> lasers) {
  VelodyneModel model;
  model.name = name;
  model.is_hdl64 = true;
  model.distance_unit = 0.002;
  model.banks = 2;
  model.sequence_ns = 48'000.0;
  model.dual_sequence_ns = 57'600.0;
  model.time_is_end = true;
  model.lasers = std::move(lasers);
  constexpr std::array<double, 4> kBeforeEndNs = {2'340.0, 3'540.0, 4'740.0, 6'000.0};
  constexpr std::array<double, 4> kDualBeforeEndNs = {3'500.0, 4'700.0, 5'900.0, 7'200.0};
  for (std::size_t id = 0; id < model.lasers.size(); ++id) {
    const std::size_t reversed = 31 - id % 32;
    const auto fours = static_cast<double>(reversed / 4);
    model.lasers[id].time_ns = model.sequence_ns - kBeforeEndNs[reversed % 4] - 6'000.0 * fours;
    model.lasers[id].dual_time_ns =
        model.dual_sequence_ns - kDualBeforeEndNs[reversed % 4] - 7'200.0 * fours;
  }
  return model;
}

// Eight lasers fire at a time, with a pause after the eighth group (manual 63-9480, page 64). Since
// firmware 5.2.3 groups are 2.89 us apart (src/packet_decoder.cpp of velodyne_decoder).
VelodyneModel vls128_model() {
  VelodyneModel model;
  model.name = "VLS-128";
  model.product = 0xa1;
  model.distance_unit = 0.004;
  model.banks = 4;
  model.sequence_ns = model.dual_sequence_ns = 53'300.0;
  model.slow_sequence_ns = 57'800.0;
  model.first_ns = -8'700.0;
  model.lasers = lasers_of(kVls128);
  set_heights(0.05863, model.lasers);
  for (std::size_t id = 0; id < model.lasers.size(); ++id) {
    const std::size_t group = id / 8;
    model.lasers[id].time_ns = 2'665.0 * static_cast<double>(group + group / 8);
  }
  return model;
}

}  // namespace

const std::vector<VelodyneModel>& velodyne_models() {
  static const std::vector<VelodyneModel> models = {
      vlp16_model(),
      hi_res_model(),
      vlp32_model(),
      hdl32_model(),
      hdl64_model("HDL-64E-S3", hdl64_s3_lasers()),
      hdl64_model("HDL-64E-S2", hdl64_s2_lasers()),
      vls128_model(),
  };
  return models;
}

std::string velodyne_product_name(std::uint8_t product) {
  char hex[8];
  std::snprintf(hex, sizeof(hex), "0x%02X", product);
  for (const VelodyneModel& model : velodyne_models()) {
    if (model.product == product) {
      return std::string(hex) + " (" + model.name + ")";
    }
  }
  return std::string(hex) + (product == 0x31 ? " (Velarray)" : " (unknown)");
}

}  // namespace surefoot::sensors
