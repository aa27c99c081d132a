// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/loops_csv.hpp"

#include <fmt/format.h>

#include <numbers>

#include "io/decimal_time.hpp"

namespace surefoot::runs {

std::string loops_csv(const mapping::Mapper& mapper, const LoopTruth* truth) {
  std::string text =
      "stamp,place_stamp,way_m,place_way_m,verdict,likeness,overlap,level_overlap,contradicted,"
      "bend_m,agreeing,"
      "started,held,drift_chi2,x_m,y_m,z_m,roll_deg,pitch_deg,yaw_deg,true_gap_m,true_gap_deg,"
      "why\n";
  const std::vector<mapping::Piece>& pieces = mapper.pieces();
  for (std::size_t i = 0; i < mapper.loops().size(); ++i) {
    const mapping::Loop& loop = mapper.loops()[i];
    const mapping::LoopCheck& check = loop.check;
    const Pose& pose = check.alignment.T_target_source;
    const Eigen::Vector3d angles = roll_pitch_yaw(pose.rotation) * 180.0 / std::numbers::pi;
    const Eigen::Vector3d& t = pose.translation;
    text +=
        fmt::format("{},{},{:.2f},{:.2f},{},{:.3f},{:.3f},{:.3f},{:.4f},{:.3f},{},{},{},{:.2f},",
                    io::format_seconds(pieces[loop.query].stamp_ns),
                    io::format_seconds(pieces[loop.place].stamp_ns), pieces[loop.query].way,
                    pieces[loop.place].way, mapping::to_string(check.verdict), loop.likeness,
                    check.overlap, check.level, check.contradicted, check.bend, check.agreeing,
                    check.started, check.alignment.held, loop.drift_chi2);
    text += fmt::format("{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},", t.x(), t.y(), t.z(),
                        angles.x(), angles.y(), angles.z());
    text += truth == nullptr
                ? ","
                : fmt::format("{:.3f},{:.3f}", truth->errors[i].metres, truth->errors[i].degrees);
    text += fmt::format(",{}\n", mapping::explain(check.verdict));
  }
  return text;
}

std::string revisits_csv(const mapping::Mapper& mapper, const LoopTruth& truth) {
  std::string text = "stamp,way_m,revisit,found\n";
  for (std::size_t i = 0; i < mapper.pieces().size(); ++i) {
    const mapping::Piece& piece = mapper.pieces()[i];
    text += fmt::format("{},{:.2f},{},{}\n", io::format_seconds(piece.stamp_ns), piece.way,
                        truth.revisits[i] ? 1 : 0, truth.found[i] ? 1 : 0);
  }
  return text;
}

}  // namespace surefoot::runs
