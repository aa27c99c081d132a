// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/all_fields.hpp"

#include <array>
#include <cmath>

namespace surefoot::io {
namespace {

std::string field(const Column& column) {
  return "field '" + column.name + "' (" + name_of(column.type) + ")";
}

// Whether any value is another after `become`, which gets and gives doubles.
template <typename Become>
bool changes(const Column& column, std::size_t points, Become&& become) {
  bool any = false;
  for_each_value(column, points, [&](std::size_t, auto value) {
    const auto wide = static_cast<double>(value);
    any = any || (std::isfinite(wide) && become(wide) != wide);
  });
  return any;
}

void find_losses(const PointTable& table, const ScanColumns& columns, const Scan& scan,
                 std::vector<std::string>& losses) {
  const Column* const intensity = columns.intensity;
  const auto to_float = [](double wide) { return static_cast<double>(static_cast<float>(wide)); };
  if (intensity != nullptr && size_of(intensity->type) >= sizeof(float) &&
      intensity->type != ScalarType::f32 && changes(*intensity, table.size, to_float)) {
    losses.push_back(field(*intensity) + " becomes a float, which rounds it");
  }
  const auto to_ring = [](double wide) { return std::trunc(std::clamp(wide, 0.0, 65535.0)); };
  if (columns.ring != nullptr && changes(*columns.ring, table.size, to_ring)) {
    losses.push_back(field(*columns.ring) +
                     " becomes a whole number from 0 to 65535, the nearest where it is none");
  }
  if (columns.time != nullptr && scan.times_ns.empty() && !scan.points.empty()) {
    losses.push_back(field(*columns.time) + " is left out: its times are not used");
  }
  for (const Column* column :
       {columns.x, columns.y, columns.z, columns.intensity, columns.ring, columns.time}) {
    if (column == nullptr || column->count < 2) continue;
    losses.push_back(field(*column) + " has " + std::to_string(column->count) +
                     " numbers a point: the first one stays");
  }
}

}  // namespace

void take_all_fields(const PointTable& table, const ScanColumns& columns, const BuiltScan& built,
                     ScanItem& item) {
  const std::array<const Column*, 6> used = {columns.x,         columns.y,    columns.z,
                                             columns.intensity, columns.ring, columns.time};
  find_losses(table, columns, built.scan, item.losses);
  if (!table.lost.empty()) item.losses.push_back(table.lost);
  std::vector<std::string> sharing;
  item.further = further_fields(table, used, built.kept, &sharing);
  for (const std::string& name : sharing) {
    item.losses.push_back("field '" + name + "' is left out: it shares its bytes with another");
  }
  // Another field of times would be taken for them where they are left out.
  const bool timeless = built.scan.times_ns.empty() && !built.scan.points.empty();
  std::erase_if(item.further, [&](const FurtherField& further) {
    const Column* const column = table.find(further.name);
    if (!timeless || column == nullptr || !may_be_times(table, *column)) return false;
    item.losses.push_back(field(*column) + " is left out: it would be read as point times");
    return true;
  });
}

}  // namespace surefoot::io
