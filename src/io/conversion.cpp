// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/conversion.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include "io/bags/bag_files.hpp"
#include "io/bags/carried_messages.hpp"
#include "io/bags/topic_name.hpp"
#include "io/bags/topic_survey.hpp"
#include "io/conversion_lane.hpp"
#include "io/file_writer.hpp"
#include "io/messages/cloud_message.hpp"
#include "io/packet_conversion.hpp"
#include "text/printable.hpp"

namespace surefoot::io {
namespace {

namespace fs = std::filesystem;

// What the endings of outputs that are no formats' are better called.
std::string advice_for(const fs::path& extension) {
  if (extension == ".db3") return "; a ROS 2 bag is a folder: FOLDER --to rosbag2";
  if (extension == ".zst" || extension == ".zstd") {
    return "; an .mcap is compressed inside, and of another 'zstd FILE' makes one";
  }
  if (extension == ".pcapng") return "; a capture's packets are written as .pcap";
  if (extension == ".laz") return "; LAZ is not written: .las, and 'laszip' makes one of it";
  return "";
}

ScanFormat wanted_format(const ConversionRequest& request) {
  if (!request.format.empty()) return scan_format_named(request.format);
  const fs::path extension = request.output.extension();
  if (extension.empty()) return ScanFormat::pcd;
  const std::string name = extension.string().substr(1);
  const std::vector<std::string>& names = scan_format_names();
  const bool known = std::find(names.begin(), names.end(), name) != names.end();
  if (known && name != "rosbag2") return scan_format_named(name);
  throw std::invalid_argument(
      request.output.string() + ": extension '" + extension.string() +
      "'; expected .mcap, .bag, .pcd, .ply, .bin, .las, of packets .pcap, or a folder (PCD, or "
      "--to says what)" +
      advice_for(extension));
}

// Called as the files of its format are.
bool is_one_file(const ConversionRequest& request, ScanFormat format) {
  const std::string& name = scan_format_names()[static_cast<std::size_t>(format)];
  return has_file_a_scan(format) && request.output.extension() == "." + name;
}

constexpr const char* kPcap = "pcap";
constexpr std::int64_t kEarliest = std::numeric_limits<std::int64_t>::min();

// Topics of a bag that goes into a bag.
struct ConvertedTopics {
  std::vector<std::string> scans, others;  ///< made of messages; copied as they are
};

// All that scans can be made of, or of those that are named what is of other messages, too. A data
// set's or a robot's topic goes before all others. Throws ReadError where one is not there.
ConvertedTopics topics_to_convert(const fs::path& bag, const std::vector<std::string>& named,
                                  const OpenOptions& reader) {
  ConvertedTopics topics;
  OpenOptions options = reader;
  if (named.empty()) {
    options.topic.clear();
    const auto source = open_bag(bag);
    for (const TopicSurvey& survey : survey_topics(*source, options).topics) {
      if (survey.usable) topics.scans.push_back(survey.topic.name);
    }
    const bool has_preset = !reader.dataset.empty() || !reader.robot.empty();
    if (has_preset || topics.scans.empty()) topics.scans = {""};  // as for a run, with its messages
    return topics;
  }
  for (const std::string& name : named) {
    options.topic = name;
    const auto source = open_bag(bag);
    const std::vector<TopicSurvey> seen = survey_topics(*source, options).topics;
    const auto found = std::find_if(seen.begin(), seen.end(), [&](const TopicSurvey& survey) {
      return survey.topic.name == name;
    });
    const bool is_other = found != seen.end() && !found->usable && named.size() > 1 &&
                          !is_cloud_type(found->topic.type);
    (is_other ? topics.others : topics.scans).push_back(name);
  }
  if (topics.scans.empty()) topics.scans = {topics.others.front()};  // which is refused with a word
  return topics;
}

// One at a time, as a run takes them, and how.
std::string one_by_one(const ConversionRequest& request) {
  std::string text = "an output holds the scans of one topic; convert them one by one:";
  for (const std::string& topic : request.topics) {
    std::string name = topic;
    std::replace(name.begin(), name.end(), '/', '_');
    fs::path output = request.output;
    output.replace_filename(output.stem().string() + name + output.extension().string());
    text += "\n  surefoot convert " + text::shell_word(request.input.string()) + ' ' +
            text::shell_word(output.string()) + " --topic " + text::shell_word(topic);
    if (!request.format.empty()) text += " --to " + request.format;
  }
  return text;
}

/// One recording turned into another.
class Conversion {
 public:
  Conversion(const ConversionRequest& request, const ConversionListener& listener)
      : request_(request),
        listener_(listener),
        format_(wanted_format(request)),
        one_file_(is_one_file(request, format_)) {
    open_input();
    require_unused(request.output, is_folder(format_) && !one_file_);
  }

  ConversionOutcome execute();

 private:
  void open_input();
  void open_lane(const std::string& topic, bool with_others);
  void open_output();
  std::unique_ptr<ScanSink> make_sink(const ConversionLane& lane, const ScanItem& first);
  /// The lane whose scan comes next; null at the end.
  ConversionLane* next_lane();
  void use(ConversionLane& lane);
  void leave_out(const std::string& why);
  void add(ConversionLane& lane);
  void copy_the_rest();
  void finish();

  const ConversionRequest& request_;
  const ConversionListener& listener_;
  ScanFormat format_;
  bool one_file_;
  std::vector<std::unique_ptr<ConversionLane>> lanes_;
  std::unique_ptr<CarriedMessages> others_;
  std::optional<UnfinishedOutput> output_;
  std::shared_ptr<BagWriter> bag_;
  ConversionOutcome outcome_;
  std::optional<std::int64_t> first_ns_, first_written_ns_;
  std::int64_t last_written_ns_ = std::numeric_limits<std::int64_t>::min();
};

void Conversion::open_lane(const std::string& topic, bool with_others) {
  OpenOptions options = request_.reader;
  options.further_fields = true;
  options.others_are_read = with_others;
  if (!topic.empty()) options.topic = topic;
  lanes_.push_back(
      std::make_unique<ConversionLane>(open_recording(request_.input, options), request_));
}

// Of a bag into a bag all topics, or those that are named; else the scans of one.
void Conversion::open_input() {
  if (!is_bag(format_) || !is_bag_input(request_.input, request_.reader)) {
    if (request_.topics.size() > 1) throw std::invalid_argument(one_by_one(request_));
    return open_lane(request_.topics.empty() ? "" : request_.topics.front(), false);
  }
  const ConvertedTopics topics =
      topics_to_convert(request_.input, request_.topics, request_.reader);
  for (const std::string& topic : topics.scans) {
    try {
      open_lane(topic, true);
    } catch (const ReadError& error) {
      if (!request_.topics.empty() || topics.scans.size() == 1) throw;
      listener_.complain("copied as it is: " + text::printable(error.what()));
    }
  }
  if (lanes_.empty()) throw ReadError(request_.input.string() + ": no topic's scans can be read");
  if (lanes_.size() > 1 && !request_.sink.topic.empty()) {
    throw std::invalid_argument("--out-topic names one topic, and the scans of " +
                                std::to_string(lanes_.size()) +
                                " are to be written: choose one with --topic");
  }
  std::set<std::string> but;
  for (const auto& lane : lanes_) but.insert(lane->recording().topic());
  const std::set<std::string> only(topics.others.begin(), topics.others.end());
  if (request_.topics.empty() || !only.empty()) {
    others_ = std::make_unique<CarriedMessages>(request_.input, std::move(but), only);
  }
}

void Conversion::open_output() {
  if (output_) return;
  output_.emplace(request_.output, is_folder(format_) && !one_file_);
  if (is_bag(format_)) bag_ = make_bag(output_->path(), format_);
}

// What is not asked for is the source's.
std::unique_ptr<ScanSink> Conversion::make_sink(const ConversionLane& lane, const ScanItem& first) {
  open_output();
  const SinkOptions usual;
  SinkOptions sink = request_.sink;
  if (sink.topic.empty()) sink.topic = lane.recording().topic();
  if (sink.topic.empty()) sink.topic = usual.topic;
  if (sink.frame.empty()) sink.frame = first.frame;
  if (sink.frame.empty()) sink.frame = usual.frame;
  sink.one_file = one_file_;
  return bag_ ? make_topic_sink(bag_, sink) : make_scan_sink(output_->path(), format_, sink);
}

void Conversion::leave_out(const std::string& why) {
  ++outcome_.unreadable;
  listener_.complain("left out: " + text::printable(why));
}

// When it came, among messages of other topics.
std::int64_t came_ns(const ScanItem& item) {
  return item.logged_ns == 0 && item.scan ? item.scan->stamp_ns : item.logged_ns;
}

ConversionLane* Conversion::next_lane() {
  ConversionLane* first = nullptr;
  std::int64_t first_ns = 0;
  for (const auto& lane : lanes_) {
    const ScanItem* const item = lane->item();
    if (item == nullptr || (first != nullptr && came_ns(*item) >= first_ns)) continue;
    first = lane.get();
    first_ns = came_ns(*item);
  }
  return first;
}

void Conversion::add(ConversionLane& lane) {
  const ScanItem& item = *lane.item();
  if (one_file_ && lane.scans() > 0) {
    throw std::invalid_argument(
        request_.output.string() +
        ": holds one scan, and there are more: name a folder, or choose one "
        "with --start N --count 1");
  }
  if (lane.sink() == nullptr) lane.set_sink(make_sink(lane, item));
  const std::int64_t at_ns = came_ns(item);
  if (!first_written_ns_) first_written_ns_ = at_ns;
  last_written_ns_ = std::max(last_written_ns_, at_ns);
  if (others_) {
    others_->copy(*bag_, request_.begins_with_all() ? kEarliest : *first_written_ns_, at_ns);
  }
  if (const std::string why = lane.add(); !why.empty()) return leave_out(why);
  ++outcome_.scans;
  listener_.progress(outcome_.scans, lane.recording().progress());
}

// Of several topics, whose LiDARs may have clocks of their own, the recorder's clock counts.
void Conversion::use(ConversionLane& lane) {
  const ScanItem& item = *lane.item();
  if (!item.scan) {
    leave_out(item.error);
  } else {
    const std::int64_t at_ns = lanes_.size() > 1 ? came_ns(item) : item.scan->stamp_ns;
    if (!first_ns_) first_ns_ = at_ns;
    if (lane.is_within(*first_ns_, at_ns)) add(lane);
  }
  lane.pass();
}

void Conversion::copy_the_rest() {
  if (!others_) return;
  others_->copy_the_rest(
      *bag_, request_.begins_with_all() ? kEarliest : *first_written_ns_,
      request_.ends_with_all() ? std::numeric_limits<std::int64_t>::max() : last_written_ns_,
      [this] { return listener_.interrupted(); });
  for (std::string& loss : others_->losses()) outcome_.losses.push_back(std::move(loss));
  outcome_.messages = others_->messages();
  outcome_.topics = others_->topics();
}

void Conversion::finish() {
  copy_the_rest();
  for (const auto& lane : lanes_) {
    outcome_.points += lane->points();
    if (lane->sink() != nullptr) lane->sink()->finish();
    const std::string topic =
        lanes_.size() > 1 ? text::printable(lane->recording().topic()) + ": " : "";
    for (const std::string& note : lane->recording().notes()) {
      const std::string line = topic + note;
      const bool known =
          std::find(outcome_.notes.begin(), outcome_.notes.end(), line) != outcome_.notes.end();
      if (!known) outcome_.notes.push_back(line);
    }
    for (const std::string& loss : lane->losses()) outcome_.losses.push_back(topic + loss);
  }
  outcome_.interrupted = listener_.interrupted();
  if (!outcome_.interrupted) output_->finish();
}

ConversionOutcome Conversion::execute() {
  while (ConversionLane* const lane = listener_.interrupted() ? nullptr : next_lane()) use(*lane);
  outcome_.interrupted = listener_.interrupted();
  if (outcome_.interrupted) return std::move(outcome_);
  if (outcome_.scans == 0) {
    throw ReadError(request_.input.string() + ": no scan in what is asked for");
  }
  finish();
  return std::move(outcome_);
}

bool is_of_packets(const ConversionRequest& request) {
  return request.format.empty() ? request.output.extension() == ".pcap" : request.format == kPcap;
}

ConversionOutcome converted(const ConversionRequest& request, const ConversionListener& listener) {
  if (!is_of_packets(request)) return Conversion(request, listener).execute();
#ifdef SUREFOOT_HAS_PCAP
  return convert_packets(request, listener);
#else
  throw std::invalid_argument(request.output.string() +
                              ": captures cannot be written: built without libpcap "
                              "(SUREFOOT_PCAP=OFF)");
#endif
}

/// What only a bag has.
std::vector<std::string> idle_sink_options(const ConversionRequest& request) {
  std::vector<std::string> notes;
  if (!is_of_packets(request) && is_bag(wanted_format(request))) return notes;
  for (const auto& [value, option] :
       {std::pair{&request.sink.topic, "--out-topic"}, std::pair{&request.sink.frame, "--frame"}}) {
    if (!value->empty()) {
      notes.push_back(std::string(option) + " counts for nothing here: it is for bags");
    }
  }
  return notes;
}

}  // namespace

const std::vector<std::string>& conversion_format_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all = scan_format_names();
    all.emplace_back(kPcap);
    return all;
  }();
  return names;
}

void require_unused(const fs::path& output, bool is_folder) {
  std::error_code ignored;
  const bool is_empty_folder =
      is_folder && fs::is_directory(output, ignored) && fs::is_empty(output, ignored);
  if (fs::exists(fs::symlink_status(output, ignored)) && !is_empty_folder) {
    throw std::invalid_argument(output.string() + ": is there already");
  }
}

ConversionOutcome convert_recording(const ConversionRequest& asked,
                                    const ConversionListener& listener) {
  ConversionRequest request = asked;
  request.topics.clear();
  for (const std::string& topic : asked.topics) {  // each once
    const auto begin = request.topics.begin(), end = request.topics.end();
    if (std::find(begin, end, topic) == end) request.topics.push_back(topic);
  }
  if (!request.sink.topic.empty() && !is_topic_name(request.sink.topic)) {
    throw std::invalid_argument("--out-topic: got '" + text::printable(request.sink.topic) +
                                "', expected a name such as /robot_1/points");
  }
  ConversionOutcome outcome = converted(request, listener);
  for (std::string& note : idle_sink_options(request)) outcome.notes.push_back(std::move(note));
  return outcome;
}

}  // namespace surefoot::io
