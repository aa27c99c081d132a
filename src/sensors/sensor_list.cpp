// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "sensors/sensor_list.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "sensors/hesai/hesai_decoder.hpp"
#include "sensors/livox/livox_decoder.hpp"
#include "sensors/ouster/ouster_decoder.hpp"
#include "sensors/robosense/rs16_decoder.hpp"
#include "sensors/velodyne/velodyne_decoder.hpp"
#include "sensors/velodyne/vlp16.hpp"

namespace surefoot::sensors {
namespace {

constexpr const char* kOuster = "Ouster";
constexpr const char* kRs16 = "RS-LiDAR-16";
constexpr const char* kLivox = "Livox Mid-360";

// "Puck Hi-Res" and "puckhires" are one.
std::string plain(const std::string& name) {
  std::string text;
  for (const char c : name) {
    if ((c >= '0' && c <= '9') || (c >= 'a' && c <= 'z')) {
      text += c;
    } else if (c >= 'A' && c <= 'Z') {
      text += static_cast<char>(c - 'A' + 'a');
    }
  }
  return text;
}

std::unique_ptr<PacketDecoder> velodyne(std::span<const std::byte> payload,
                                        const std::string& wanted, const DecoderOptions& options,
                                        std::string& reason) {
  if (wanted.empty()) {
    std::optional<VelodyneModel> model = find_velodyne_model(payload, reason);
    return model ? std::make_unique<VelodyneDecoder>(std::move(*model), options) : nullptr;
  }
  for (VelodyneModel model : velodyne_models()) {
    if (plain(model.name) == wanted && payload.size() == vlp16::kPacketBytes) {
      model.product.reset();  // whatever the packet says
      return std::make_unique<VelodyneDecoder>(model, options);
    }
  }
  return nullptr;
}

std::unique_ptr<PacketDecoder> hesai(std::span<const std::byte> payload, const std::string& wanted,
                                     const DecoderOptions& options) {
  const HesaiModel* model = find_hesai_model(payload);
  return model != nullptr && (wanted.empty() || plain(model->name) == wanted)
             ? std::make_unique<HesaiDecoder>(*model, options)
             : nullptr;
}

// Nothing in an Ouster's packet says that it is one, but its size.
std::unique_ptr<PacketDecoder> ouster(std::span<const std::byte> payload, const std::string& wanted,
                                      const DecoderOptions& options, std::string& reason) {
  const bool like_one = is_ouster_size(payload.size());
  if (wanted.empty() ? !like_one : wanted != plain(kOuster)) {
    return nullptr;
  }
  if (options.calibration.empty() && options.metadata.empty()) {
    reason =
        "an Ouster's by their size, whose metadata (JSON) is not here: give it with "
        "--calibration";
    return nullptr;
  }
  OusterMetadata metadata;
  try {
    metadata =
        parse_ouster_metadata(options.calibration.empty() ? options.metadata : options.calibration);
  } catch (const CalibrationError& error) {
    if (!options.calibration.empty()) {
      throw;
    }
    reason = std::string("an Ouster's by their size, but what came with them is no metadata: ") +
             error.what();
    return nullptr;
  }
  if (metadata.packet_bytes() != payload.size()) {
    if (like_one) {
      reason = "an Ouster's by their size, but its metadata says packets of " +
               std::to_string(metadata.packet_bytes()) + " bytes";
    }
    return nullptr;
  }
  return std::make_unique<OusterDecoder>(std::move(metadata), options);
}

}  // namespace

std::vector<std::string> sensor_names() {
  std::vector<std::string> names;
  for (const VelodyneModel& model : velodyne_models()) {
    names.push_back(model.name);
  }
  for (const HesaiModel& model : hesai_models()) {
    names.push_back(model.name);
  }
  for (const char* name : {kOuster, kRs16, kLivox}) {
    names.emplace_back(name);
  }
  return names;
}

bool is_sensor_name(const std::string& name) {
  const std::vector<std::string> names = sensor_names();
  return std::any_of(names.begin(), names.end(),
                     [&](const std::string& one) { return plain(one) == plain(name); });
}

std::string named_sensor(std::span<const std::byte> payload) {
  std::string ignored;
  const std::optional<VelodyneModel> model = find_velodyne_model(payload, ignored);
  return model && model->product ? model->name : "";
}

std::unique_ptr<PacketDecoder> find_decoder(std::span<const std::byte> payload,
                                            const std::string& sensor,
                                            const DecoderOptions& options, std::string& reason) {
  const std::string wanted = plain(sensor);
  std::vector<std::unique_ptr<PacketDecoder>> candidates;
  candidates.push_back(velodyne(payload, wanted, options, reason));
  candidates.push_back(hesai(payload, wanted, options));
  candidates.push_back(ouster(payload, wanted, options, reason));
  if (const std::string other = other_robosense_model(payload); !other.empty()) {
    reason = "data packets of RoboSense's " + other;
  }
  if (wanted.empty() || wanted == plain(kRs16)) {
    candidates.push_back(std::make_unique<Rs16Decoder>(options));
  }
  if (wanted.empty() || wanted == plain(kLivox)) {
    candidates.push_back(std::make_unique<LivoxDecoder>());
  }
  Firings firings;
  for (std::unique_ptr<PacketDecoder>& decoder : candidates) {
    if (decoder != nullptr && decoder->decode(payload, firings) == PacketKind::data) {
      return std::move(decoder);
    }
  }
  return nullptr;
}

}  // namespace surefoot::sensors
