// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/scans_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>
#include <sstream>

#include "io/ascii_values.hpp"
#include "io/decimal_time.hpp"
#include "io/recording.hpp"
#include "io/saturated.hpp"
#include "report/joined_names.hpp"
#include "runs/csv_table.hpp"

namespace surefoot::runs {

using io::ReadError;

namespace {

constexpr const char* kStamp = "stamp";
constexpr const char* kStatus = "status";
constexpr const char* kMessage = "message";
constexpr const char* kDegenerate = "degenerate";
constexpr const char* kStages = "stages";
constexpr const char* kTotalTime = "ms_total";

struct Column {
  enum class Kind { text, number };
  std::string name;
  Kind kind;
  std::function<std::string(const ScanRow&)> value;
};

Column whole(std::string name, int Estimate::*member) {
  return {std::move(name), Column::Kind::number,
          [member](const ScanRow& row) { return std::to_string(row.estimate.*member); }};
}

Column real(std::string name, std::function<double(const Estimate&)> value) {
  return {std::move(name), Column::Kind::number, [value = std::move(value)](const ScanRow& row) {
            return fmt::format("{:.6f}", value(row.estimate));
          }};
}

/// The columns of the stage at this place of Estimate::stages, empty where a scan has none there.
void add_stage(std::size_t place, std::vector<Column>& columns) {
  const auto add = [&](const char* part, std::string (*value)(const StageReport&)) {
    columns.push_back({fmt::format("stage{}_{}", place + 1, part), Column::Kind::number,
                       [place, value](const ScanRow& row) {
                         const StageReports& stages = row.estimate.stages;
                         return place < stages.size() ? value(stages[place]) : std::string();
                       }});
  };
  add("iterations", [](const StageReport& stage) { return std::to_string(stage.iterations); });
  add("matches", [](const StageReport& stage) { return std::to_string(stage.matches); });
  add("residual_m", [](const StageReport& stage) { return fmt::format("{:.6f}", stage.residual); });
  add("observability", [](const StageReport& stage) {  // which no other stage has
    return stage.name == "vertical" ? fmt::format("{:.6f}", stage.observability) : std::string();
  });
}

void add_sigmas(std::vector<Column>& columns) {
  const char* const names[] = {"sigma_x_m",      "sigma_y_m",       "sigma_z_m",
                               "sigma_roll_rad", "sigma_pitch_rad", "sigma_yaw_rad"};
  for (int i = 0; i < 6; ++i) {
    columns.push_back({names[i], Column::Kind::number, [i](const ScanRow& row) {
                         return fmt::format("{:.3e}", std::sqrt(row.estimate.covariance(i, i)));
                       }});
  }
}

/// Empty where nothing is told.
std::string probability_of(const ScanRow& row) {
  const double probability = row.estimate.wrong_probability;
  return std::isnan(probability) ? "" : fmt::format("{:.6f}", probability);
}

void add_evidence(std::vector<Column>& columns) {
  columns.push_back({"wrong_probability", Column::Kind::number, probability_of});
  for (const EvidenceField& field : kEvidenceFields) {
    columns.push_back(
        real(std::string("evidence_") + field.name,
             [member = field.member](const Estimate& e) { return e.evidence.*member; }));
  }
}

void add_times(std::vector<Column>& columns) {
  for (std::size_t step = 0; step < kStepNames.size(); ++step) {
    columns.push_back(
        {std::string("ms_") + kStepNames[step], Column::Kind::number, [step](const ScanRow& row) {
           return fmt::format("{:.4f}", row.times.milliseconds()[step]);
         }});
  }
  columns.push_back({kTotalTime, Column::Kind::number,
                     [](const ScanRow& row) { return fmt::format("{:.4f}", row.times.total()); }});
}

std::vector<Column> make_columns() {
  using Kind = Column::Kind;
  std::vector<Column> columns = {
      {"scan", Kind::number, [](const ScanRow& row) { return std::to_string(row.scan); }},
      {"name", Kind::text, [](const ScanRow& row) { return csv_quoted(row.name); }},
      {kStamp, Kind::text,
       [](const ScanRow& row) { return io::format_seconds(row.estimate.stamp_ns); }},
      {kStatus, Kind::text,
       [](const ScanRow& row) { return std::string(to_string(row.estimate.status)); }},
      {"segment", Kind::number,
       [](const ScanRow& row) { return std::to_string(row.estimate.segment); }},
      {kMessage, Kind::text, [](const ScanRow& row) { return csv_quoted(row.estimate.message); }},
      real("x", [](const Estimate& e) { return e.T_world_lidar.translation.x(); }),
      real("y", [](const Estimate& e) { return e.T_world_lidar.translation.y(); }),
      real("z", [](const Estimate& e) { return e.T_world_lidar.translation.z(); }),
      whole("points", &Estimate::points),
      whole("registered_points", &Estimate::registered_points),
      {"converged", Kind::number,
       [](const ScanRow& row) { return std::string(row.estimate.converged ? "1" : "0"); }}};
  columns.push_back({kStages, Column::Kind::text,
                     [](const ScanRow& row) { return report::joined_names(row.estimate.stages); }});
  for (std::size_t place = 0; place < StageReports::kMost; ++place) add_stage(place, columns);
  columns.push_back({kDegenerate, Kind::text, [](const ScanRow& row) {
                       return report::joined_names(row.estimate.degenerate);
                     }});
  columns.push_back(real("least_information", [](const Estimate& e) {
    return e.degenerate.empty() ? 1.0 : e.degenerate.front().information;
  }));
  add_sigmas(columns);
  add_evidence(columns);
  add_times(columns);
  return columns;
}

const std::vector<Column>& columns() {
  static const std::vector<Column> table = make_columns();
  return table;
}

bool is_text(const std::string& name) {
  return std::any_of(columns().begin(), columns().end(), [&](const Column& column) {
    return column.name == name && column.kind == Column::Kind::text;
  });
}

/// Takes scans.csv row by row: of each scan its numbers, and the few texts that are told.
class ScanRows {
 public:
  void begin(const CsvHead& head) {
    head_ = head;
    stamp_ = head.column(kStamp);
    (void)head.column(kStatus);
    for (std::size_t column = 0; column < head.names.size(); ++column) {
      const std::string& name = head.names[column];
      if (!is_text(name)) numbers_.push_back(column);
      if (name == kStages) stages_ = column;
    }
    // Texts that an older program did not write are empty.
    for (const auto& [name, texts] :
         {std::pair(kStatus, &scans_.statuses), std::pair(kMessage, &scans_.messages),
          std::pair(kDegenerate, &scans_.degenerate)}) {
      const auto found = std::find(head.names.begin(), head.names.end(), name);
      const auto column = static_cast<std::size_t>(found - head.names.begin());
      texts_.emplace_back(column, texts);
    }
    for (const std::size_t column : numbers_) scans_.columns.push_back({head.names[column], {}});
  }

  void add(const std::vector<std::string>& row) {
    const auto stamp = io::parse_decimal_seconds(row[stamp_]);
    if (!stamp) refuse(stamp_, row[stamp_]);
    scans_.stamps_ns.push_back(*stamp);
    for (const auto& [column, texts] : texts_) {
      texts->push_back(column < row.size() ? row[column] : std::string());
    }
    if (stages_) add_stages(row[*stages_]);
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
      const std::string& field = row[numbers_[i]];
      double value = std::numeric_limits<double>::quiet_NaN();
      if (!field.empty() && !io::parse_real(field, value)) refuse(numbers_[i], field);
      scans_.columns[i].values.push_back(static_cast<float>(value));
    }
  }

  [[nodiscard]] report::ScanTable take() { return std::move(scans_); }

 private:
  /// A run has one method: the stages of whichever scan went through most of them.
  void add_stages(const std::string& names) {
    if (names == last_stages_) return;
    last_stages_ = names;
    std::istringstream words(names);
    std::vector<std::string> stages{std::istream_iterator<std::string>(words), {}};
    if (stages.size() > scans_.stages.size()) scans_.stages = std::move(stages);
  }

  /// Of the scan whose stamp was taken last, or refused.
  [[noreturn]] void refuse(std::size_t column, const std::string& field) const {
    const std::size_t row = scans_.size() - (column == stamp_ ? 0 : 1);
    throw ReadError(fmt::format("{}: line {}: {} is {}, no number", head_.file, csv_line(row),
                                head_.names[column], io::in_quotes(field)));
  }

  CsvHead head_;
  std::size_t stamp_ = 0;
  std::optional<std::size_t> stages_;
  std::vector<std::pair<std::size_t, std::vector<std::string>*>> texts_;
  std::vector<std::size_t> numbers_;  // columns of scans_.columns
  std::string last_stages_;
  report::ScanTable scans_;
};

/// The whole table's lines, each column by its own `value`.
std::string joined(const std::function<std::string(const Column&)>& value) {
  std::string line;
  for (const Column& column : columns()) {
    if (!line.empty()) line += ',';
    line += value(column);
  }
  line += '\n';
  return line;
}

}  // namespace

std::string scans_csv_header() {
  return joined([](const Column& column) { return column.name; });
}

std::string scans_csv_beginning() { return "scan,name,stamp,status,"; }

std::string scans_csv_line(const ScanRow& row) {
  return joined([&](const Column& column) { return column.value(row); });
}

report::ScanTable read_scans_csv(const std::filesystem::path& file) {
  ScanRows rows;
  read_csv_rows(
      file, [&](const CsvHead& head) { rows.begin(head); },
      [&](const std::vector<std::string>& row) { rows.add(row); });
  return rows.take();
}

ScansByStamp::ScansByStamp(const report::ScanTable& scans) {
  for (const std::int64_t stamp_ns : scans.stamps_ns) scans_.emplace_back(stamp_ns, scans_.size());
  std::sort(scans_.begin(), scans_.end());
}

std::size_t ScansByStamp::nearest(std::int64_t stamp_ns, std::size_t from) const {
  const auto first_of = [&](std::int64_t stamp, std::size_t scan) {
    return std::lower_bound(scans_.begin(), scans_.end(), std::pair(stamp, scan));
  };
  auto near = first_of(stamp_ns, 0);
  if (near == scans_.end()) --near;
  const auto away = [&](auto scan) { return io::distance(scan->first, stamp_ns); };
  if (near != scans_.begin() && away(std::prev(near)) < away(near)) --near;
  const std::int64_t found_ns = near->first;
  const auto next = first_of(found_ns, from);
  const bool is_there = next != scans_.end() && next->first == found_ns;
  return is_there ? next->second : std::prev(next)->second;
}

std::map<std::string, std::size_t> count_statuses(const report::ScanTable& scans) {
  std::map<std::string, std::size_t> counts;
  for (const std::string& status : scans.statuses) ++counts[status];
  return counts;
}

std::vector<double> scan_milliseconds(const report::ScanTable& scans,
                                      const std::filesystem::path& file) {
  for (const report::ScanColumn& column : scans.columns) {
    if (column.name == kTotalTime) return {column.values.begin(), column.values.end()};
  }
  throw ReadError(fmt::format("{}: line 1: no column '{}'; expected a run's scans.csv",
                              file.string(), kTotalTime));
}

}  // namespace surefoot::runs
