// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/bags/carried_messages.hpp"

#include "io/bags/bag_files.hpp"
#include "io/counted.hpp"
#include "text/printable.hpp"

namespace surefoot::io {
namespace {

constexpr std::size_t kMostTopics = 10'000;
// Messages of a bag in order of time are no further from their places [ns].
constexpr std::int64_t kOutOfOrder = 10'000'000'000;

bool is_latched(const Topic& topic) {
  return topic.name.ends_with("tf_static") || (topic.definition && topic.definition->latched);
}

MessageDefinition definition_of(const Topic& topic) {
  const TopicDefinition known = topic.definition ? *topic.definition : TopicDefinition{};
  MessageDefinition definition;
  definition.type = topic.type;
  definition.latched = known.latched;
  if (topic.encoding == MessageEncoding::ros1) {
    definition.ros1_text = known.text;
    definition.ros1_md5 = known.md5.empty() ? "*" : known.md5;  // any, as ROS has it
    return definition;
  }
  definition.ros2_name = known.type;
  definition.ros2_text = known.text.empty() ? known_ros2_text(topic.type) : known.text;
  if (!known.text.empty()) definition.ros2_language = known.language;
  definition.qos = known.qos;
  return definition;
}

const char* name_of(MessageEncoding encoding) {
  return encoding == MessageEncoding::cdr    ? "ROS 2's encoding (cdr)"
         : encoding == MessageEncoding::ros1 ? "ROS 1's encoding"
                                             : "neither ROS 1's encoding nor ROS 2's";
}

}  // namespace

CarriedMessages::CarriedMessages(const std::filesystem::path& bag, std::set<std::string> but,
                                 std::set<std::string> only)
    : bag_(open_bag(bag)), but_(std::move(but)), only_(std::move(only)) {}

bool CarriedMessages::is_meant(const Topic& topic) const {
  return but_.count(topic.name) == 0 && (only_.empty() || only_.count(topic.name) > 0);
}

CarriedMessages::Way CarriedMessages::way_of(const Topic& topic, BagWriter& to) {
  const bool ros1 = to.flavour() == MessageWriter::Flavour::ros1;
  const MessageEncoding taken = ros1 ? MessageEncoding::ros1 : MessageEncoding::cdr;
  Way way;
  if (topic.encoding != taken) {
    way.why = std::string("they are in ") + name_of(topic.encoding) + ", the output's are in " +
              name_of(taken);
    return way;
  }
  // Where it takes a slash to name a type, a bag without one would be no bag.
  if (topic.name.empty() || topic.type.find('/') == std::string::npos) {
    way.why = "the bag does not name their type";
    return way;
  }
  const MessageDefinition definition = definition_of(topic);
  way.without_text = (ros1 ? definition.ros1_text : definition.ros2_text).empty();
  way.topic = to.add_topic(topic.name, definition);
  return way;
}

void CarriedMessages::copy(BagWriter& to, std::int64_t from_ns, std::int64_t upto_ns) {
  while (!ended_) {
    if (!next_) next_ = bag_->next();
    ended_ = !next_;
    if (ended_ || next_->logged_ns > upto_ns) return;
    const Message message = *next_;
    next_.reset();
    const Topic& topic = *message.topic;
    if (!is_meant(topic) || (message.logged_ns < from_ns && !is_latched(topic))) continue;
    const Key key{topic.name, topic.type};
    auto found = ways_.find(key);
    if (found == ways_.end()) {
      if (ways_.size() >= kMostTopics) continue;
      found = ways_.emplace(key, way_of(topic, to)).first;
    }
    Way& way = found->second;
    ++way.messages;
    if (!way.topic) continue;
    const auto* const bytes = reinterpret_cast<const char*>(message.bytes.data());
    to.write_published(*way.topic, message.logged_ns,
                       message.published_ns.value_or(message.logged_ns),
                       {bytes, message.bytes.size()});
    ++messages_;
  }
}

void CarriedMessages::copy_the_rest(BagWriter& to, std::int64_t from_ns, std::int64_t upto_ns,
                                    const std::function<bool()>& interrupted) {
  copy(to, from_ns, upto_ns);
  while (!ended_ && !interrupted()) {  // the next message is too late
    if (bag_->is_in_order_of_time() && next_->logged_ns - kOutOfOrder > upto_ns) return;
    next_.reset();
    copy(to, from_ns, upto_ns);
  }
}

std::size_t CarriedMessages::topics() const {
  std::size_t count = 0;
  for (const auto& [key, way] : ways_) count += way.topic ? 1 : 0;
  return count;
}

std::vector<std::string> CarriedMessages::losses() const {
  constexpr std::size_t kMostLines = 40;
  std::vector<std::string> lines;
  for (const auto& [key, way] : ways_) {
    if (lines.size() >= kMostLines) break;
    const std::string topic = text::printable(key.first) + " (" + text::printable(key.second) + ")";
    if (!way.topic) {
      lines.push_back("lost: " + std::to_string(way.messages) + " messages of " + topic + ": " +
                      way.why);
    } else if (way.without_text) {
      lines.push_back("no text of the type of " + topic +
                      " is known: who needs it to show messages cannot show these");
    }
  }
  const PassedOver& passed_over = bag_->passed_over();
  if (passed_over.attachments > 0) {
    lines.push_back("lost: " + counted(passed_over.attachments, "attachment"));
  }
  if (passed_over.metadata > 0) {
    lines.push_back("lost: " + counted(passed_over.metadata, "record") + " of metadata");
  }
  if (ways_.size() >= kMostTopics) {
    lines.push_back("lost: topics beyond " + std::to_string(kMostTopics));
  }
  return lines;
}

}  // namespace surefoot::io
