// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "sensors/velodyne/velodyne_decoder.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "sensors/bytes.hpp"
#include "sensors/packet_order.hpp"
#include "sensors/rings.hpp"
#include "sensors/velodyne/velodyne_calibration.hpp"
#include "sensors/velodyne/vlp16.hpp"

namespace surefoot::sensors {
namespace {

using Bytes = std::span<const std::byte>;
using vlp16::kAzimuthUnitsPerTurn;
using vlp16::kBlockBytes;
using vlp16::kBlocks;
using vlp16::kChannelsPerBlock;
using vlp16::kPacketBytes;

constexpr std::size_t kBlockHeaderBytes = 4;  // flag and azimuth
constexpr std::size_t kReturnBytes = 3;
constexpr std::size_t kTail = kBlocks * kBlockBytes;
constexpr double kUnit = 0.01 * std::numbers::pi / 180.0;  // [rad]

// 1200 rpm turn 0.8 deg between blocks; a larger step, or none, is no turning head [0.01 deg].
constexpr int kLargestStep = 200;

std::uint16_t u16(Bytes bytes, std::size_t at) {
  return load<std::uint16_t>(bytes.data() + at, false);
}
std::uint16_t flag_of(Bytes packet, std::size_t block) { return u16(packet, block * kBlockBytes); }
int azimuth_of(Bytes packet, std::size_t block) { return u16(packet, block * kBlockBytes + 2); }

// The flags of the blocks of a sequence, first bank first, as little-endian numbers.
constexpr std::array<std::uint16_t, 4> kBankFlags = {0xeeff, 0xddff, 0xccff, 0xbbff};

// A VLS-128's two returns fill eight blocks; what is in the last four is no data.
std::size_t blocks_in_use(Bytes payload) {
  constexpr std::uint8_t kVls128 = 0xa1;
  const bool is_dual = std::to_integer<std::uint8_t>(payload[kTail + 4]) == vlp16::kDual;
  return is_dual && std::to_integer<std::uint8_t>(payload[kTail + 5]) == kVls128 ? 8 : kBlocks;
}

// A data packet's blocks have flags, and azimuths below a turn.
bool has_blocks(Bytes payload) {
  if (payload.size() != kPacketBytes) {
    return false;
  }
  for (std::size_t block = 0; block < blocks_in_use(payload); ++block) {
    const std::uint16_t flag = flag_of(payload, block);
    if (std::find(kBankFlags.begin(), kBankFlags.end(), flag) == kBankFlags.end() ||
        azimuth_of(payload, block) >= kAzimuthUnitsPerTurn) {
      return false;
    }
  }
  return true;
}

int turn_between(int from, int to) {
  return (to - from + kAzimuthUnitsPerTurn) % kAzimuthUnitsPerTurn;
}

// Whether a block's second 16 distances are those of the same lasers a moment later, as of 16
// lasers, and not of others. Seen in the first 400 packets of ten captures, of those with 60 pairs:
// in the median one 0.9 and more of the pairs agree in six of VLP-16s, at most 0.11 in four of
// HDL-32Es, of whose packets none had more than 0.53.
bool fires_each_laser_twice(Bytes payload) {
  constexpr int kFewest = 48, kAlike = 50;  // pairs; distances are so many times their difference
  int pairs = 0, alike = 0;
  for (std::size_t block = 0; block < vlp16::kBlocks; ++block) {
    const std::size_t first = block * kBlockBytes + kBlockHeaderBytes;
    for (std::size_t laser = 0; laser < vlp16::kLasers; ++laser) {
      const int once = u16(payload, first + laser * kReturnBytes);
      const int again = u16(payload, first + (laser + vlp16::kLasers) * kReturnBytes);
      if (once == 0 || again == 0) continue;
      ++pairs;
      if (kAlike * std::abs(once - again) <= std::max(once, again)) ++alike;
    }
  }
  return pairs >= kFewest && 10 * alike >= 7 * pairs;
}

// What a calibration file corrects, zeros without one, as the ROS driver does (manual 63-HDL64E,
// appendix on calibration): of an HDL-64E two distances were measured, along either axis, and what
// lies between is interpolated.
Eigen::Vector3d corrected_point(const VelodyneLaser& laser, double distance, double cosine,
                                double sine, double azimuth) {
  constexpr double kFar = 25.04;  // [m]
  constexpr double kNearX = 2.4;
  constexpr double kNearY = 1.93;
  const double vertical = laser.vertical_offset;
  const double horizontal = laser.horizontal_offset;
  const double cos_azimuth = std::cos(azimuth);
  const double sin_azimuth = std::sin(azimuth);
  double along_x = distance + laser.distance;
  double along_y = along_x;
  if (laser.two_points) {
    const double flat = along_x * cosine - vertical * sine;
    const double x = std::abs(flat * sin_azimuth - horizontal * cos_azimuth);
    const double y = std::abs(flat * cos_azimuth + horizontal * sin_azimuth);
    along_x = distance + laser.distance_x +
              (laser.distance - laser.distance_x) * (x - kNearX) / (kFar - kNearX);
    along_y = distance + laser.distance_y +
              (laser.distance - laser.distance_y) * (y - kNearY) / (kFar - kNearY);
  }
  const double flat_x = along_x * cosine - vertical * sine;
  const double flat_y = along_y * cosine - vertical * sine;
  // The manual's x is to the right, its y forward.
  const double right = flat_x * sin_azimuth - horizontal * cos_azimuth;
  const double forward = flat_y * cos_azimuth + horizontal * sin_azimuth;
  return {forward, -right, along_y * sine + vertical * cosine + laser.height};
}

}  // namespace

struct VelodyneDecoder::Layout {
  bool dual = false;
  std::size_t stride = 1;     ///< blocks of one azimuth
  std::size_t positions = 1;  ///< azimuths
  double sequence_ns = 0.0;   ///< from one firing sequence to the next
};

struct VelodyneDecoder::Shot {
  const Laser& laser;
  double azimuth = 0.0;  ///< [rad]
  double time_ns = 0.0;  ///< after the first laser of its sequence
};

struct VelodyneDecoder::Head {
  std::size_t block = 0;    ///< first of the position
  std::size_t channel = 0;  ///< first of the sequence in its block
  double azimuth = 0.0;     ///< of the first laser [0.01 deg]
  double step = 0.0;        ///< to the next sequence [0.01 deg]
  bool dual = false;
};

VelodyneDecoder::VelodyneDecoder(VelodyneModel model, const DecoderOptions& options)
    : model_(std::move(model)), choice_(options.returns) {
  if (!options.calibration.empty()) {
    apply_velodyne_calibration(options.calibration, model_);
  }
  std::vector<double> elevations;
  for (const VelodyneLaser& laser : model_.lasers) {
    elevations.push_back(laser.elevation_deg);
  }
  const std::vector<std::uint16_t> rings = rings_of(elevations);
  for (std::size_t id = 0; id < model_.lasers.size(); ++id) {
    Laser laser{model_.lasers[id], 1.0, 0.0, rings[id]};
    const double elevation = laser.table.elevation_deg * std::numbers::pi / 180.0;
    laser.cosine = std::cos(elevation);
    laser.sine = std::sin(elevation);
    if (!options.beam_origins) {
      laser.table.height = 0.0;
      if (!model_.is_hdl64) laser.table.vertical_offset = 0.0;  // of which that is what it is
    }
    lasers_.push_back(laser);
  }
  constexpr double kTurnNs = 1e8;  // 600 rpm
  usual_step_ = kAzimuthUnitsPerTurn * model_.sequence_ns / kTurnNs;
}

std::string VelodyneDecoder::return_mode() const {
  switch (mode_) {
    case vlp16::kStrongest:
      return "single, strongest";
    case vlp16::kLast:
      return "single, last";
    case vlp16::kDual:
      return "dual";
    default:
      return "single";
  }
}

// An HDL-64E does not say it: its status byte goes through other things. Two firings of the same
// azimuth do.
bool VelodyneDecoder::is_dual(Bytes payload) const {
  if (!model_.is_hdl64) {
    return std::to_integer<std::uint8_t>(payload[kTail + 4]) == vlp16::kDual;
  }
  return azimuth_of(payload, 0) == azimuth_of(payload, 2) &&
         azimuth_of(payload, 4) == azimuth_of(payload, 6) &&
         azimuth_of(payload, 0) != azimuth_of(payload, 4);
}

VelodyneDecoder::Layout VelodyneDecoder::layout_of(bool dual) const {
  Layout layout;
  layout.dual = dual;
  layout.stride = model_.banks * (dual ? 2 : 1);
  layout.positions = kBlocks / layout.stride;  // VLS-128, dual: four blocks are unused
  layout.sequence_ns = pace_ * (dual ? model_.dual_sequence_ns : model_.sequence_ns);
  return layout;
}

/// How far the head turns in a sequence: from an azimuth to the next; to the last one from the one
/// before, be it that of the packet before.
void VelodyneDecoder::learn_step(Bytes payload, const Layout& layout, std::size_t position) {
  const auto azimuth = [&](std::size_t at) { return azimuth_of(payload, at * layout.stride); };
  int turn = 0;
  if (position + 1 < layout.positions) {
    turn = turn_between(azimuth(position), azimuth(position + 1));
  } else if (layout.positions > 1) {
    turn = turn_between(azimuth(position - 1), azimuth(position));
  } else if (last_azimuth_ >= 0) {
    turn = turn_between(last_azimuth_, azimuth(position));
  }
  if (turn <= 0 || turn > kLargestStep) return;
  usual_step_ = static_cast<double>(turn) / static_cast<double>(model_.sequences_per_block);
}

/// Which of two firmwares it is, told by how long the last packet's sequences took.
void VelodyneDecoder::learn_pace(double sequence_ns) {
  if (model_.slow_sequence_ns == 0.0) return;
  const double slow = model_.slow_sequence_ns / model_.sequence_ns;
  pace_ = 2.0 * sequence_ns > model_.sequence_ns + model_.slow_sequence_ns ? slow : 1.0;
}

PacketKind VelodyneDecoder::decode(Bytes payload, Firings& firings) {
  firings.clear();
  if (payload.size() != kPacketBytes) return PacketKind::other;
  if (!has_blocks(payload)) return PacketKind::malformed;
  const auto mode = std::to_integer<std::uint8_t>(payload[kTail + 4]);
  const auto product = std::to_integer<std::uint8_t>(payload[kTail + 5]);
  const bool known = mode == vlp16::kStrongest || mode == vlp16::kLast || mode == vlp16::kDual;
  if ((!model_.is_hdl64 && !known) || (model_.product && product != *model_.product)) {
    return PacketKind::other;
  }
  const Layout layout = layout_of(is_dual(payload));
  mode_ = !model_.is_hdl64 ? mode : (layout.dual ? vlp16::kDual : std::uint8_t{0});
  const std::size_t sequences = layout.positions * model_.sequences_per_block;
  firings.base = TimeBase::hour;
  firings.time_ns = 1000LL * load<std::uint32_t>(payload.data() + kTail, false);
  firings.period_ns = std::llround(layout.sequence_ns * static_cast<double>(sequences));
  if (follows(firings, last_time_ns_)) {
    learn_pace(static_cast<double>(firings.time_ns - last_time_ns_) /
               static_cast<double>(sequences));
  } else {
    last_azimuth_ = -1;
  }
  for (std::size_t i = 0; i < sequences; ++i) {
    const std::size_t position = i / model_.sequences_per_block;
    const std::size_t part = i % model_.sequences_per_block;
    const std::size_t block = position * layout.stride;
    learn_step(payload, layout, position);
    Head head{block, part * kChannelsPerBlock / model_.sequences_per_block,
              azimuth_of(payload, block) + static_cast<double>(part) * usual_step_, usual_step_,
              layout.dual};
    head.azimuth -= head.azimuth >= kAzimuthUnitsPerTurn ? kAzimuthUnitsPerTurn : 0;
    Firing firing;
    const double since_first = layout.sequence_ns * static_cast<double>(i);
    firing.offset_ns =
        std::llround(model_.first_ns + since_first) - (model_.time_is_end ? firings.period_ns : 0);
    firing.duration_ns = std::llround(layout.sequence_ns);
    firing.azimuth_deg = 0.01 * head.azimuth;
    firing.turned_deg = 0.01 * head.step;
    add_sequence(payload, head, firings);
    firing.end = firings.points.size();
    firings.firings.push_back(firing);
  }
  last_azimuth_ = azimuth_of(payload, (layout.positions - 1) * layout.stride);
  last_time_ns_ = firings.time_ns;
  return PacketKind::data;
}

void VelodyneDecoder::add_sequence(Bytes payload, const Head& head, Firings& firings) const {
  const std::size_t channels = kChannelsPerBlock / model_.sequences_per_block;
  // Two blocks of a bank follow each other, or the blocks of one return those of the other.
  const bool interleaved =
      head.dual && flag_of(payload, head.block) == flag_of(payload, head.block + 1);
  const double sequence_ns = head.dual ? model_.dual_sequence_ns : model_.sequence_ns;
  for (std::size_t bank = 0; bank < model_.banks; ++bank) {
    const std::size_t first_block = head.block + bank * (interleaved ? 2 : 1);
    const std::size_t second_block = first_block + (interleaved ? 1 : model_.banks);
    const auto return_at = [&](std::size_t block, std::size_t channel) {
      const std::size_t at =
          block * kBlockBytes + kBlockHeaderBytes + (head.channel + channel) * kReturnBytes;
      return Return{u16(payload, at), std::to_integer<std::uint8_t>(payload[at + 2])};
    };
    for (std::size_t channel = 0; channel < channels; ++channel) {
      const Laser& laser = lasers_[bank * kChannelsPerBlock + channel];
      const double time_ns =
          head.dual ? laser.table.dual_time_ns.value_or(laser.table.time_ns) : laser.table.time_ns;
      const double azimuth = (head.azimuth + head.step * time_ns / sequence_ns) * kUnit +
                             laser.table.azimuth_deg * std::numbers::pi / 180.0;
      const auto add = [&](const Return& measured) {
        add_point({laser, azimuth, time_ns}, measured, firings);
      };
      const Return last = return_at(first_block, channel);
      const Return other = head.dual ? return_at(second_block, channel) : Return{};
      // Where the last return is the strongest, the other block holds the second strongest.
      const bool other_is_strongest =
          head.dual && other.distance != 0 && other.reflectivity >= last.reflectivity;
      if (!head.dual || choice_ == ReturnChoice::last) {
        add(last);
      } else if (choice_ == ReturnChoice::strongest) {
        add(other_is_strongest || last.distance == 0 ? other : last);
      } else {
        add(last);
        if (other.distance != last.distance) {
          add(other);
        }
      }
    }
  }
}

void VelodyneDecoder::add_point(const Shot& shot, Return measured, Firings& firings) const {
  if (measured.distance == 0) {
    return;
  }
  const double distance = model_.distance_unit * measured.distance;
  const Laser& laser = shot.laser;
  FiringPoint point;
  point.position =
      corrected_point(laser.table, distance, laser.cosine, laser.sine, shot.azimuth).cast<float>();
  point.intensity = measured.reflectivity;
  point.offset_ns = static_cast<std::int32_t>(pace_ * shot.time_ns);
  point.ring = laser.ring;
  firings.points.push_back(point);
}

std::optional<VelodyneModel> find_velodyne_model(Bytes payload, std::string& reason) {
  if (!has_blocks(payload)) return std::nullopt;
  const auto product = std::to_integer<std::uint8_t>(payload[kTail + 5]);
  const auto model_of = [](auto&& fits) -> std::optional<VelodyneModel> {
    const auto& models = velodyne_models();
    const auto found = std::find_if(models.begin(), models.end(), fits);
    if (found == models.end()) return std::nullopt;
    return *found;
  };
  // The HDL-64E's last byte is its status' value; its two banks tell it.
  const bool two_banks = flag_of(payload, 0) == kBankFlags[0] &&
                         flag_of(payload, 1) == kBankFlags[1] &&
                         flag_of(payload, 2) == kBankFlags[0];
  if (two_banks) {
    return model_of([](const VelodyneModel& model) { return model.name == "HDL-64E-S3"; });
  }
  std::optional<VelodyneModel> found =
      model_of([product](const VelodyneModel& model) { return model.product == product; });
  if (found && found->name == "HDL-32E" && fires_each_laser_twice(payload)) {
    found = model_of([](const VelodyneModel& model) { return model.name == "VLP-16"; });
    found->product.reset();  // whatever the packet says
  }
  if (!found) {
    reason = "data packets of Velodyne's product " + velodyne_product_name(product);
  }
  return found;
}

}  // namespace surefoot::sensors
