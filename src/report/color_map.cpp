// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "report/color_map.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace surefoot::report {

namespace {
// The map of Smith and van der Walt at 16 even steps, 0xRRGGBB; between them it is straight enough.
constexpr std::array<std::uint32_t, 16> kViridis = {
    0x440154, 0x481a6c, 0x472f7d, 0x414487, 0x39568c, 0x31688e, 0x2a788e, 0x23888e,
    0x1f988b, 0x22a884, 0x35b779, 0x54c568, 0x7ad151, 0xa5db36, 0xd2e21b, 0xfde725};

double channel(std::uint32_t rgb, int shift) {
  return static_cast<double>((rgb >> shift) & 0xFFU) / 255.0;
}
}  // namespace

Color viridis(double value) {
  const double at = std::clamp(value, 0.0, 1.0) * static_cast<double>(kViridis.size() - 1);
  const std::size_t low = std::min(static_cast<std::size_t>(at), kViridis.size() - 2);
  const double weight = at - static_cast<double>(low);
  const auto mix = [&](int shift) {
    return (1.0 - weight) * channel(kViridis[low], shift) +
           weight * channel(kViridis[low + 1], shift);
  };
  return {mix(16), mix(8), mix(0)};
}

}  // namespace surefoot::report
