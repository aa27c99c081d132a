// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "dataset/ply_writer.hpp"

#include <stdexcept>

#include "dataset/file_writer.hpp"

namespace surefoot::dataset {

std::string format_ply(std::span<const Eigen::Vector3f> points, std::span<const float> intensities,
                       PlyFlavour flavour) {
  if (!intensities.empty() && intensities.size() != points.size()) {
    throw std::invalid_argument(std::to_string(intensities.size()) + " intensities for " +
                                std::to_string(points.size()) + " points");
  }
  const bool ascii = flavour == PlyFlavour::kAscii;
  std::string out = std::string("ply\nformat ") + (ascii ? "ascii" : "binary_little_endian") +
                    " 1.0\ncomment Surefoot\nelement vertex " + std::to_string(points.size()) +
                    "\nproperty float x\nproperty float y\nproperty float z\n";
  out += intensities.empty() ? "end_header\n" : "property float intensity\nend_header\n";
  out.reserve(out.size() + (ascii ? 40 : 16) * points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3f& point = points[i];
    const float values[] = {point.x(), point.y(), point.z(),
                            intensities.empty() ? 0.0F : intensities[i]};
    for (const float value : std::span(values).first(intensities.empty() ? 3 : 4)) {
      if (ascii) {
        append_text(out, value);
        out += ' ';
      } else {
        append_bytes(out, value);
      }
    }
    if (ascii) {
      out.back() = '\n';
    }
  }
  return out;
}

void write_ply(const std::filesystem::path& file, std::span<const Eigen::Vector3f> points,
               std::span<const float> intensities, PlyFlavour flavour) {
  write_whole_file(file, format_ply(points, intensities, flavour));
}

}  // namespace surefoot::dataset
