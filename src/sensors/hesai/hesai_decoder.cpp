// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "sensors/hesai/hesai_decoder.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sensors/bytes.hpp"
#include "sensors/calendar.hpp"
#include "sensors/hesai/hesai_calibration.hpp"
#include "sensors/packet_order.hpp"
#include "sensors/rings.hpp"

namespace surefoot::sensors {
namespace {

using Bytes = std::span<const std::byte>;

constexpr int kUnitsPerTurn = 36'000;                      // 0.01 deg
constexpr double kUnit = 0.01 * std::numbers::pi / 180.0;  // [rad]
// 1200 rpm turn 1.2 deg between blocks of the slowest sensor; more is no turning head [0.01 deg].
constexpr int kLargestStep = 300;

std::uint8_t u8(Bytes bytes, std::size_t at) { return std::to_integer<std::uint8_t>(bytes[at]); }
std::uint16_t u16(Bytes bytes, std::size_t at) {
  return load<std::uint16_t>(bytes.data() + at, false);
}

struct ReturnMode {
  std::uint8_t code;
  std::size_t returns;
  const char* name;
};
constexpr std::array<ReturnMode, 10> kModes = {{{0x33, 1, "single, first"},
                                                {0x34, 1, "single, second"},
                                                {0x37, 1, "single, strongest"},
                                                {0x38, 1, "single, last"},
                                                {0x39, 2, "dual, last and strongest"},
                                                {0x3a, 2, "dual, first and second"},
                                                {0x3b, 2, "dual, first and last"},
                                                {0x3c, 2, "dual, first and strongest"},
                                                {0x3d, 3, "triple, first, last and strongest"},
                                                {0x3e, 2, "dual, the two strongest"}}};

const ReturnMode* mode_of(std::uint8_t code) {
  const auto* const found = std::find_if(kModes.begin(), kModes.end(),
                                         [&](const ReturnMode& one) { return one.code == code; });
  return found == kModes.end() ? nullptr : found;
}

std::size_t block_at(const HesaiModel& model, std::size_t block) {
  return model.header_bytes + block * model.block_bytes();
}

int azimuth_of(Bytes payload, const HesaiModel& model, std::size_t block) {
  return u16(payload, block_at(model, block) + model.block_header_bytes - 2);
}

bool fits(Bytes payload, const HesaiModel& model) {
  if (std::find(model.sizes.begin(), model.sizes.end(), payload.size()) == model.sizes.end()) {
    return false;
  }
  constexpr std::uint16_t kMagic = 0xffee;  // EE FF
  if (model.header_bytes == 0) {
    return u16(payload, 0) == 0xeeff;  // the flag of the first block
  }
  const std::size_t counts_at = model.header_bytes == 12 ? 6 : 2;
  return u16(payload, 0) == kMagic && u8(payload, counts_at) == model.channels.size() &&
         u8(payload, counts_at + 1) == model.blocks;
}

}  // namespace

struct HesaiDecoder::Group {
  std::size_t block = 0;  ///< first of them
  std::size_t returns = 1;
  double azimuth = 0.0;  ///< [0.01 deg]
  double per_ns = 0.0;   ///< how fast the head turns [0.01 deg / ns]
  bool odd = false;      ///< the other of two firing sequences
  double distance_unit = 0.004;
};

HesaiDecoder::HesaiDecoder(HesaiModel model, const DecoderOptions& options)
    : model_(std::move(model)), choice_(options.returns) {
  if (!options.calibration.empty()) {
    apply_hesai_calibration(options.calibration, model_);
  }
  std::vector<double> elevations;
  for (const HesaiChannel& channel : model_.channels) {
    elevations.push_back(channel.elevation_deg);
  }
  const std::vector<std::uint16_t> rings = rings_of(elevations);
  for (std::size_t i = 0; i < model_.channels.size(); ++i) {
    const double elevation = elevations[i] * std::numbers::pi / 180.0;
    channels_.push_back({model_.channels[i], std::cos(elevation), std::sin(elevation), rings[i]});
  }
  constexpr double kTurnNs = 1e8;  // 600 rpm
  usual_step_ = kUnitsPerTurn * model_.block_ns / kTurnNs;
}

std::string HesaiDecoder::return_mode() const {
  const ReturnMode* mode = mode_of(mode_);
  return mode == nullptr ? "unknown" : mode->name;
}

// Millimetres, where there is a header that says it.
double HesaiDecoder::distance_unit(Bytes payload) const {
  return model_.header_bytes == 0 ? 0.004 : 0.001 * u8(payload, model_.header_bytes == 12 ? 9 : 5);
}

/// What the tail says of all the packet's blocks. Returns how many of them, one for each return,
/// lie at an azimuth: 0 where the packet is malformed.
std::size_t HesaiDecoder::read_tail(Bytes payload, Firings& firings) {
  const Bytes tail = payload.subspan(model_.tail.begin);
  const ReturnMode* mode = mode_of(u8(tail, model_.tail.return_mode));
  const std::optional<std::int64_t> second = unix_seconds(tail.subspan(model_.tail.date));
  const auto microseconds = load<std::uint32_t>(tail.data() + model_.tail.microseconds, false);
  constexpr std::uint32_t kMostMicroseconds = 2'000'000;  // with a leap second
  if (mode == nullptr || !second || microseconds > kMostMicroseconds ||
      model_.blocks % mode->returns != 0 || distance_unit(payload) == 0.0) {
    return 0;
  }
  mode_ = mode->code;
  firings.base = TimeBase::absolute;
  firings.time_ns = *second * 1'000'000'000 + microseconds * 1000LL;
  const auto groups = static_cast<double>(model_.blocks / mode->returns);
  firings.period_ns = std::llround(model_.block_ns * groups);
  if (model_.tail.sequence && tail.size() >= *model_.tail.sequence + 4) {
    firings.number = load<std::uint32_t>(tail.data() + *model_.tail.sequence, false);
    firings.numbers = std::uint64_t{1} << 32U;
  }
  return mode->returns;
}

/// How far the head turns from a group of blocks to the next; of the last one, from the one before,
/// be it that of the packet before.
void HesaiDecoder::learn_step(Bytes payload, std::size_t at, std::size_t groups,
                              std::size_t returns) {
  const auto azimuth = [&](std::size_t group) {
    return azimuth_of(payload, model_, group * returns);
  };
  const bool last = at + 1 == groups;
  const int before = !last ? azimuth(at) : groups > 1 ? azimuth(at - 1) : last_azimuth_;
  const int turn = (azimuth(last ? at : at + 1) - before + kUnitsPerTurn) % kUnitsPerTurn;
  if (before >= 0 && turn > 0 && turn <= kLargestStep) usual_step_ = turn;
}

PacketKind HesaiDecoder::decode(Bytes payload, Firings& firings) {
  firings.clear();
  if (!fits(payload, model_)) return PacketKind::other;
  for (std::size_t block = 0; block < model_.blocks; ++block) {
    if (azimuth_of(payload, model_, block) >= kUnitsPerTurn) return PacketKind::malformed;
  }
  const std::size_t returns = read_tail(payload, firings);
  if (returns == 0) return PacketKind::malformed;
  if (!follows(firings, last_time_ns_)) last_azimuth_ = -1;
  const std::size_t groups = model_.blocks / returns;
  const unsigned flag = u8(payload.subspan(model_.tail.begin), model_.tail.mode_flag.value_or(0));
  for (std::size_t i = 0; i < groups; ++i) {
    const std::size_t block = i * returns;
    const int azimuth = azimuth_of(payload, model_, block);
    learn_step(payload, i, groups, returns);
    Group group{block, returns, static_cast<double>(azimuth), usual_step_ / model_.block_ns};
    group.distance_unit = distance_unit(payload);
    // With one return the two sequences take turns, with more the packet says which one it is.
    group.odd = model_.two_loops && (returns == 1 ? block % 2 == 1 : (flag & 1U) == 0);
    const auto after_first = static_cast<double>(i);
    const auto before_last = static_cast<double>(groups - 1 - i);
    Firing firing;
    firing.offset_ns =
        std::llround(model_.last_ns + (model_.counts_forward ? model_.block_ns * after_first
                                                             : -model_.block_ns * before_last));
    firing.duration_ns = std::llround(model_.block_ns);
    firing.azimuth_deg = 0.01 * azimuth;
    firing.turned_deg = 0.01 * usual_step_;
    add_group(payload, group, firings);
    firing.end = firings.points.size();
    firings.firings.push_back(firing);
  }
  last_azimuth_ = azimuth_of(payload, model_, model_.blocks - 1);
  last_time_ns_ = firings.time_ns;
  return PacketKind::data;
}

void HesaiDecoder::add_group(Bytes payload, const Group& group, Firings& firings) const {
  struct Return {
    std::uint16_t distance = 0;
    std::uint8_t reflectivity = 0;
  };
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    const Channel& channel = channels_[i];
    std::array<Return, 3> returns;
    for (std::size_t k = 0; k < group.returns; ++k) {
      const std::size_t at =
          block_at(model_, group.block + k) + model_.block_header_bytes + i * model_.unit_bytes;
      returns[k] = {u16(payload, at), u8(payload, at + 2)};
    }
    const std::int32_t time_ns = group.odd ? channel.table.odd_time_ns : channel.table.time_ns;
    const double azimuth = (group.azimuth + group.per_ns * time_ns) * kUnit +
                           channel.table.azimuth_deg * std::numbers::pi / 180.0;
    const auto add = [&](const Return& measured) {
      if (measured.distance == 0) {
        return;
      }
      const double distance = group.distance_unit * measured.distance;
      const double horizontal = distance * channel.cosine;
      firings.points.push_back({{static_cast<float>(horizontal * std::sin(azimuth)),
                                 static_cast<float>(horizontal * std::cos(azimuth)),
                                 static_cast<float>(distance * channel.sine)},
                                static_cast<float>(measured.reflectivity),
                                time_ns,
                                channel.ring});
    };
    const auto end = returns.begin() + static_cast<std::ptrdiff_t>(group.returns);
    if (choice_ == ReturnChoice::last) {
      add(*std::max_element(returns.begin(), end, [](const Return& a, const Return& b) {
        return a.distance < b.distance;
      }));
    } else if (choice_ == ReturnChoice::strongest) {
      // No return at all is weaker than any.
      const auto strength = [](const Return& one) {
        return one.distance == 0 ? -1 : static_cast<int>(one.reflectivity);
      };
      add(*std::max_element(returns.begin(), end, [&](const Return& a, const Return& b) {
        return strength(a) < strength(b);
      }));
    } else {
      for (auto one = returns.begin(); one != end; ++one) {
        const bool repeated = std::any_of(returns.begin(), one, [&](const Return& other) {
          return other.distance == one->distance;
        });
        if (!repeated) {
          add(*one);
        }
      }
    }
  }
}

const HesaiModel* find_hesai_model(Bytes payload) {
  for (const HesaiModel& model : hesai_models()) {
    if (fits(payload, model)) {
      return &model;
    }
  }
  return nullptr;
}

}  // namespace surefoot::sensors
