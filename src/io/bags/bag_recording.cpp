// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/bags/bag_recording.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "io/bags/bag_files.hpp"
#include "io/bags/topic_recordings.hpp"
#include "io/bags/topic_survey.hpp"
#include "io/messages/cloud_message.hpp"
#include "io/messages/packet_message.hpp"
#include "io/robots.hpp"
#include "text/printable.hpp"

namespace surefoot::io {
namespace {

// Empty where the bag has none of them. A robot's own is asked for: its mount is not that of
// others.
std::string likely_topic(const std::vector<TopicSurvey>& topics, const OpenOptions& options) {
  if (const Robot* const robot = robot_of_scans(options)) return robot->topic;
  for (const std::string& name : options.likely_topics) {
    for (const TopicSurvey& survey : topics) {
      if (survey.usable && survey.topic.name == name) return name;
    }
  }
  return {};
}

// The first of the topics that are not read.
std::string others(const std::vector<TopicSurvey>& topics, const std::set<std::string>& read) {
  constexpr std::size_t kMost = 10;
  std::string text;
  std::size_t count = 0;
  for (const TopicSurvey& survey : topics) {
    if (read.count(survey.topic.name) > 0 || ++count > kMost) continue;
    text += (text.empty() ? "" : ", ") + survey.topic.name;
  }
  return count > kMost ? text + " and " + std::to_string(count - kMost) + " more" : text;
}

// Where no topic can be taken, what reading met may be why.
Topic choose_with_notes(const std::vector<TopicSurvey>& topics, const std::string& asked,
                        const TopicRecordingParts& parts) {
  try {
    return choose_topic(topics, asked, parts.bag).topic;
  } catch (const ReadError& error) {
    std::string text = error.what();
    for (const std::string& note : parts.messages.notes()) text += "\nnote: " + note;
    throw ReadError(text);
  }
}

// What a preset would have taken, where the bag does not have it; empty: it has, or none was asked.
std::string missed_text(const OpenOptions& options, const std::string& taken) {
  const auto& likely = options.likely_topics;
  if (std::find(likely.begin(), likely.end(), taken) != likely.end()) return {};
  if (!options.topic.empty() || likely.empty()) return {};
  std::string names;
  for (const std::string& name : likely) names += (names.empty() ? "" : ", ") + name;
  return "topic: " + options.dataset + " has " + names + ", this bag has no scans there; " +
         text::printable(taken) + " is taken instead";
}

}  // namespace

BagTopic open_bag_topic(const std::filesystem::path& path, const OpenOptions& options) {
  return open_bag_topic(TopicMessages([path] { return open_bag(path); }), path.string(), options);
}

BagTopic open_bag_topic(TopicMessages messages, const std::string& name,
                        const OpenOptions& options) {
  TopicRecordingParts parts{name, std::move(messages), {}, {}, options.others_are_read};
  BagSurvey survey = survey_topics(parts.messages.bag(), options);
  const std::string asked =
      options.topic.empty() ? likely_topic(survey.topics, options) : options.topic;
  Topic topic = choose_with_notes(survey.topics, asked, parts);
  if (std::string text = missed_text(options, topic.name); !text.empty()) {
    parts.notes.push_back(std::move(text));
  }
  if (survey.topics.size() > 1 && !options.others_are_read) {
    std::set<std::string> read = {topic.name};
    if (is_packet_type(topic.type)) read.insert(survey.metadata_topic_for(topic.name));
    const std::string left = others(survey.topics, read);
    parts.notes.push_back("topic: " + topic.name + ", one of " +
                          std::to_string(survey.topics.size()) + " in the bag" +
                          (left.empty() ? "" : "; not read: " + left));
  }
  for (TopicSurvey& one : survey.topics) parts.seen.push_back(std::move(one.topic));
  std::string metadata = survey.metadata_for(topic.name);
  return {std::move(parts), std::move(topic), std::move(metadata)};
}

void TopicRecordingParts::note_late_topics() {
  if (others_are_read) return;
  std::string names;
  for (const Topic& topic : messages.bag().announced()) {
    const auto is_same = [&](const Topic& one) { return one.name == topic.name; };
    const bool scans = is_cloud_type(topic.type) || is_packet_type(topic.type);
    if (!scans || std::any_of(seen.begin(), seen.end(), is_same)) continue;
    names += (names.empty() ? "" : ", ") + text::printable(topic.name);
    seen.push_back(topic);
  }
  if (!names.empty()) {
    notes.push_back("the bag has topics of scans that do not begin in its first seconds: " + names +
                    " (--topic takes one)");
  }
}

std::unique_ptr<Recording> open_bag_recording(const std::filesystem::path& path,
                                              const OpenOptions& options) {
  BagTopic bag = open_bag_topic(path, options);
  return is_packet_type(bag.topic.type)
             ? open_packet_topic(std::move(bag.parts), bag.topic, options, bag.calibration)
             : open_cloud_topic(std::move(bag.parts), bag.topic, options);
}

}  // namespace surefoot::io
