// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <new>
#include <set>

#include "io/all_fields.hpp"
#include "io/bags/topic_recordings.hpp"
#include "io/counted.hpp"
#include "io/messages/cloud_message.hpp"
#include "io/saturated.hpp"
#include "io/scan_builder.hpp"

namespace surefoot::io {
namespace {

// Messages that are looked at for the meaning of the point times, and damaged ones among them.
constexpr int kMostLookedAt = 20, kMostDamaged = 1000;
// Sensors that are named beside the one that is read.
constexpr std::size_t kMostOthers = 10;

class CloudTopic final : public Recording {
 public:
  CloudTopic(TopicRecordingParts parts, const Topic& topic, const OpenOptions& options)
      : parts_(std::move(parts)), options_(options) {
    parts_.messages.begin(topic);
    find_point_time_rule();
    parts_.messages.begin(topic);
    note_stamps();
    if (rule_) parts_.notes.push_back(rule_text_);
  }

  std::optional<ScanItem> next() override {
    std::optional<Heard> heard = next_of_sensor();
    if (!heard) return std::nullopt;
    ScanItem item;
    item.name = "message " + std::to_string(next_ - 1);
    item.logged_ns = heard->message.logged_ns;
    if (heard->cloud) {
      heard->trouble = trouble_in([&] { make_scan(*heard->cloud, heard->message, item); });
    }
    if (!heard->trouble.empty()) item.error = where() + ", " + item.name + ": " + heard->trouble;
    return item;
  }

  std::optional<std::size_t> size() const override { return std::nullopt; }
  void skip(std::size_t scans) override {
    while (scans > 0 && next_of_sensor()) --scans;
  }
  double progress() const override { return parts_.messages.progress(); }
  const std::vector<std::string>& notes() const override { return parts_.notes; }
  std::vector<std::string> losses() const override {
    std::vector<std::string> all = parts_.messages.losses();
    if (left_out_ > 0) {
      all.push_back(counted(left_out_, "message") + " of other sensors on the topic left out");
    }
    return all;
  }
  std::string topic() const override { return parts_.messages.topic().name; }
  std::string description() const override { return parts_.messages.description(); }

 private:
  [[nodiscard]] std::string where() const {
    return parts_.bag + ": " + parts_.messages.topic().name;
  }

  std::optional<Message> next_message() {
    const std::optional<Message> message = parts_.messages.next();
    const std::vector<std::string>& notes = parts_.messages.notes();
    for (; bag_notes_ < notes.size(); ++bag_notes_) parts_.notes.push_back(notes[bag_notes_]);
    if (!message) parts_.note_late_topics();
    return message;
  }

  /// A message, and what is in it or why that cannot be read.
  struct Heard {
    Message message;
    std::optional<CloudMessage> cloud = {};
    std::string trouble = {};
  };

  /// Why some work on a message could not be done; empty: it was.
  template <typename Work>
  [[nodiscard]] static std::string trouble_in(const Work& work) {
    try {
      work();
      return {};
    } catch (const ReadError& error) {
      return error.what();
    } catch (const std::bad_alloc&) {
      return "takes more memory than there is";
    }
  }

  /// The next message of the first one's sensor: of two that are mixed, no run can be made.
  std::optional<Heard> next_of_sensor() {
    while (std::optional<Message> message = next_message()) {
      ++next_;
      Heard heard{*message};
      heard.trouble = trouble_in([&] { heard.cloud = read(heard.message); });
      if (!heard.cloud || !is_anothers(*heard.cloud)) return heard;
    }
    return std::nullopt;
  }

  bool is_anothers(const CloudMessage& cloud) {
    const std::string sensor = sensor_of(cloud);
    if (sensor == sensor_) return false;
    ++left_out_;
    if (others_.size() < kMostOthers && others_.insert(sensor).second) {
      parts_.notes.push_back("topic: " + parts_.messages.topic().name + " is of several sensors: " +
                             sensor_ + " is read; left out: " + sensor);
    }
    return true;
  }

  [[nodiscard]] CloudMessage read(const Message& message) const {
    return read_cloud(message.topic->type, message.topic->encoding, message.bytes);
  }
  static std::int64_t stamp_of(const CloudMessage& cloud, const Message& message) {
    return cloud.stamp_ns == 0 ? message.logged_ns : sane_time(cloud.stamp_ns);
  }

  [[nodiscard]] bool times_are_left_out() const {
    return options_.time_direction == TimeDirection::none;
  }

  void find_point_time_rule() {
    std::string first_error;
    bool settled = false;
    int& good = looked_at_;
    for (int damaged = 0; good < kMostLookedAt && damaged < kMostDamaged && !settled;) {
      const std::optional<Message> message = parts_.messages.next();
      if (!message) break;
      try {
        const CloudMessage cloud = read(*message);
        const ScanColumns columns = find_scan_columns(cloud.table, options_);
        if (sensor_.empty()) take_sensor(cloud);
        if (sensor_of(cloud) != sensor_) continue;
        zero_stamps_ += cloud.stamp_ns == 0 ? 1 : 0;
        look_at_times(cloud, stamp_of(cloud, *message), columns);
        settled = columns.time == nullptr || times_are_left_out() || is_confirmed_ ||
                  (rule_ && rule_->certain && rule_->unit_certain);
        ++good;
      } catch (const ReadError& error) {
        if (first_error.empty()) first_error = error.what();
        ++damaged;
      } catch (const std::bad_alloc&) {
        if (first_error.empty()) first_error = "a message takes more memory than there is";
        ++damaged;
      }
    }
    if (good == 0) throw ReadError(where() + ": " + first_error);
  }

  void take_sensor(const CloudMessage& cloud) {
    sensor_ = sensor_of(cloud);
    const std::string why = why_no_scans(parts_.messages.topic().name, cloud.frame);
    if (why.empty()) return;
    parts_.notes.push_back("topic: " + why + ": is there one of the LiDAR's own?");
  }

  void note_stamps() {
    std::string note = "stamps: from the messages' headers";
    if (zero_stamps_ > 0) {
      note += "; where these are zero, as in " + std::to_string(zero_stamps_) + " of the first " +
              std::to_string(looked_at_) + ", when they were recorded counts";
    }
    parts_.notes.push_back(std::move(note));
  }

  void look_at_times(const CloudMessage& cloud, std::int64_t stamp_ns, const ScanColumns& columns) {
    if (columns.time == nullptr || times_are_left_out()) return;
    const TimeExtents extents = time_extents(cloud.table, columns);
    if (extents.count == 0) return;
    try {
      const PointTimeRule rule =
          decide_point_time(extents, columns.time->type, stamp_ns,
                            with_defined_unit(options_, cloud.table, *columns.time));
      is_confirmed_ = last_rule_ && confirms(rule, *last_rule_);
      last_rule_ = rule;
      if (rule_ && !knows_better(rule, *rule_)) return;
      rule_ = rule;
      rule_text_ = describe_point_time(columns.time->name, columns.time->type, rule, extents);
    } catch (const ReadError& error) {
      throw ReadError("field '" + columns.time->name + "': " + error.what());
    }
  }

  /// From a message behind the first ones, none of which had times that differ.
  void learn_times(const CloudMessage& cloud, std::int64_t stamp_ns, const ScanColumns& columns) {
    const std::string before = rule_text_;
    try {
      look_at_times(cloud, stamp_ns, columns);
    } catch (const ReadError&) {
      if (!rule_) throw;
    }
    if (rule_text_ != before) parts_.notes.push_back(rule_text_);
  }

  void make_scan(const CloudMessage& cloud, const Message& message, ScanItem& item) {
    item.layout = cloud.table.layout();
    const ScanColumns columns = find_scan_columns(cloud.table, options_);
    const std::int64_t stamp_ns = stamp_of(cloud, message);
    if (!rule_ || rule_->spread == 0.0) learn_times(cloud, stamp_ns, columns);
    BuiltScan built = build_scan(cloud.table, columns, rule_, stamp_ns, options_.stamp_at);
    item.dropped_points = built.dropped_points;
    item.dropped_not_finite = built.dropped_not_finite;
    item.dropped_zero = built.dropped_zero;
    item.frame = cloud.frame;
    if (options_.further_fields) take_all_fields(cloud.table, columns, built, item);
    item.rounded_by = built.rounded_by;
    item.clock = built.clock;
    item.scan = std::move(built.scan);
  }

  TopicRecordingParts parts_;
  OpenOptions options_;
  std::optional<PointTimeRule> rule_, last_rule_;
  bool is_confirmed_ = false;  ///< the last message's rule, by the one before
  std::string rule_text_;
  std::string sensor_;            ///< whose messages are read
  std::set<std::string> others_;  ///< that are left out
  std::size_t left_out_ = 0;      ///< messages of them
  std::size_t bag_notes_ = 0;
  std::size_t next_ = 0;
  int looked_at_ = 0;    ///< messages that the point times' meaning was found from
  int zero_stamps_ = 0;  ///< of them
};

}  // namespace

std::unique_ptr<Recording> open_cloud_topic(TopicRecordingParts parts, const Topic& topic,
                                            const OpenOptions& options) {
  return std::make_unique<CloudTopic>(std::move(parts), topic, options);
}

}  // namespace surefoot::io
