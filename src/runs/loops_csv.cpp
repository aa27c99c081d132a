// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/loops_csv.hpp"

#include <fmt/format.h>

#include <numbers>

#include "io/ascii_values.hpp"
#include "io/decimal_time.hpp"
#include "io/recording.hpp"
#include "runs/csv_table.hpp"
#include "runs/scans_csv.hpp"

namespace surefoot::runs {

namespace {

constexpr const char* kFigureNames =
    "likeness,overlap,level_overlap,contradicted,bend_m,agreeing,started,held,";
constexpr const char* kPoseNames = "x_m,y_m,z_m,roll_deg,pitch_deg,yaw_deg,";

std::string figures_of(const mapping::Loop& loop) {
  const mapping::LoopCheck& check = loop.check;
  return fmt::format("{:.3f},{:.3f},{:.3f},{:.4f},{:.3f},{},{},{},", loop.likeness, check.overlap,
                     check.level, check.contradicted, check.bend, check.agreeing, check.started,
                     check.alignment.held);
}

std::string pose_of(const mapping::Loop& loop) {
  const Pose& pose = loop.check.alignment.T_target_source;
  const Eigen::Vector3d angles = roll_pitch_yaw(pose.rotation) * 180.0 / std::numbers::pi;
  const Eigen::Vector3d& t = pose.translation;
  return fmt::format("{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},", t.x(), t.y(), t.z(), angles.x(),
                     angles.y(), angles.z());
}

}  // namespace

std::string loops_csv(const std::vector<mapping::Piece>& pieces,
                      const std::vector<mapping::Loop>& loops, const LoopTruth* truth) {
  std::string text = fmt::format(
      "stamp,place_stamp,way_m,place_way_m,verdict,{}drift_chi2,{}true_gap_m,true_gap_deg,why\n",
      kFigureNames, kPoseNames);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const mapping::Loop& loop = loops[i];
    text += fmt::format("{},{},{:.2f},{:.2f},{},{}{:.2f},{}",
                        io::format_seconds(pieces[loop.query].stamp_ns),
                        io::format_seconds(pieces[loop.place].stamp_ns), pieces[loop.query].way,
                        pieces[loop.place].way, mapping::to_string(loop.check.verdict),
                        figures_of(loop), loop.drift_chi2, pose_of(loop));
    text += truth == nullptr
                ? ","
                : fmt::format("{:.3f},{:.3f}", truth->errors[i].metres, truth->errors[i].degrees);
    text += fmt::format(",{}\n", csv_quoted(mapping::explain(loop.check.verdict)));
  }
  return text;
}

std::vector<report::ReportLoop> read_loops_csv(const std::filesystem::path& file,
                                               const report::ScanTable& scans) {
  const CsvTable table = read_csv_table(file);
  const std::size_t verdict = table.column("verdict");
  const std::size_t why = table.column("why");
  const std::size_t stamp = table.column("stamp");
  const std::size_t place_stamp = table.column("place_stamp");
  const ScansByStamp by_stamp(scans);
  const auto scan_at = [&](std::size_t row, std::size_t column, std::size_t from) {
    const std::string& field = table.rows[row][column];
    const auto stamp_ns = io::parse_decimal_seconds(field);
    if (!stamp_ns) {
      throw io::ReadError(fmt::format("{}: line {}: {} is {}, no number", table.file, csv_line(row),
                                      table.names[column], io::in_quotes(field)));
    }
    return by_stamp.nearest(*stamp_ns, from);
  };
  std::vector<report::ReportLoop> loops;
  for (std::size_t row = 0; scans.size() > 0 && row < table.rows.size(); ++row) {
    const std::size_t place = scan_at(row, place_stamp, 0);
    const std::size_t scan = scan_at(row, stamp, place + 1);  // who is there again
    loops.push_back({scan, place, table.rows[row][verdict], table.rows[row][why]});
  }
  return loops;
}

std::string join_csv_header() {
  return fmt::format("map,stamp,place_stamp,verdict,{}{}why\n", kFigureNames, kPoseNames);
}

std::string join_csv(const mapping::MapJoin& join, std::size_t map) {
  std::string text;
  for (const mapping::Loop& loop : join.loops) {
    text += fmt::format("{},{},{},{},{}{}{}\n", map,
                        io::format_seconds(join.pieces[loop.query].stamp_ns),
                        io::format_seconds(join.pieces[loop.place].stamp_ns),
                        mapping::to_string(loop.check.verdict), figures_of(loop), pose_of(loop),
                        csv_quoted(mapping::explain(loop.check.verdict)));
  }
  return text;
}

std::string revisits_csv(const mapping::WalkMapper& mapper, const LoopTruth& truth) {
  std::string text = "stamp,way_m,revisit,found\n";
  for (std::size_t i = 0; i < mapper.pieces().size(); ++i) {
    const mapping::Piece& piece = mapper.pieces()[i];
    text += fmt::format("{},{:.2f},{},{}\n", io::format_seconds(piece.stamp_ns), piece.way,
                        truth.revisits[i] ? 1 : 0, truth.found[i] ? 1 : 0);
  }
  return text;
}

}  // namespace surefoot::runs
