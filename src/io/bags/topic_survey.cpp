// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/bags/topic_survey.hpp"

#include <algorithm>
#include <cstdio>
#include <map>
#include <new>
#include <utility>

#include "io/messages/cloud_message.hpp"
#include "io/messages/message_reader.hpp"
#include "io/messages/packet_message.hpp"
#include "io/packets/packet_scans.hpp"
#include "surefoot/seconds.hpp"
#include "text/printable.hpp"

namespace surefoot::io {
namespace {

constexpr std::int64_t kLookedAtNs = 2'000'000'000;
constexpr std::size_t kMostTopics = 10'000;
// Messages of a topic that are tried before it counts as of no use, and again with new metadata.
constexpr std::size_t kMostTried = 200;
constexpr std::size_t kMostMetadata = 16;  // of topics
constexpr std::size_t kMostMetadataBytes = 4'000'000;
constexpr std::size_t kMostListed = 40;

void look_into_cloud(const Message& message, TopicSurvey& survey) {
  survey.usable = true;  // where this one is damaged, the next one may be whole
  const CloudMessage cloud = read_cloud(survey.topic.type, survey.topic.encoding, message.bytes);
  survey.frame = cloud.frame;
  survey.content = std::to_string(cloud.table.size) + " points, " + cloud.table.layout();
  survey.usable = cloud.table.find("x") != nullptr && cloud.table.find("y") != nullptr &&
                  cloud.table.find("z") != nullptr;
}

void look_into_packets(const Message& message, const OpenOptions& options,
                       const std::string& calibration, TopicSurvey& survey) {
  PacketScans scans(options, calibration);
  std::size_t packets = 0;
  for_each_packet(message, [&](const MessagePacket& packet) {
    ++packets;
    scans.add(packet.stamp_ns, packet.bytes);
  });
  survey.usable = scans.found();
  survey.content = std::to_string(packets) + (packets == 1 ? " packet of " : " packets of ") +
                   (scans.found() ? scans.sensor() : "no sensor that is known");
  if (!scans.found() && !scans.reason().empty()) survey.content += ": " + scans.reason();
}

void look_into(const Message& message, const OpenOptions& options, const std::string& calibration,
               TopicSurvey& survey) {
  try {
    if (is_cloud_type(survey.topic.type)) {
      look_into_cloud(message, survey);
    } else if (is_packet_type(survey.topic.type)) {
      look_into_packets(message, options, calibration, survey);
    }
  } catch (const ReadError& error) {
    survey.content = error.what();
  } catch (const std::bad_alloc&) {
    survey.content = "takes more memory than there is";
  }
}

// Ouster's metadata is a text on a topic of its own.
std::string metadata_in(const Message& message) {
  if (message.topic->type != "std_msgs/String" || !message.topic->name.ends_with("metadata") ||
      message.bytes.size() > kMostMetadataBytes) {
    return {};
  }
  try {
    return std::string(MessageReader(message.topic->encoding, message.bytes).string("metadata"));
  } catch (const ReadError&) {
    return {};
  }
}

// Each topic's first. Packets before it could not be read without it: they are tried again.
void take_metadata(const Message& message, BagSurvey& found) {
  if (found.metadata.size() >= kMostMetadata) return;
  std::string text = metadata_in(message);
  if (text.empty() || !found.metadata.try_emplace(message.topic->name, std::move(text)).second) {
    return;
  }
  for (TopicSurvey& survey : found.topics) {
    if (is_packet_type(survey.topic.type)) survey.tried = 0;
  }
}

/// "  /points  sensor_msgs/PointCloud2  10.0 Hz  frame lidar  28800 points, x f32, ..."
std::string line_of(const TopicSurvey& survey) {
  char rate[40];
  std::snprintf(rate, sizeof(rate), "%.1f Hz", survey.rate_hz());
  std::string line =
      "  " + text::printable(survey.topic.name) + "  " + text::printable(survey.topic.type);
  if (survey.messages > 1) line += std::string("  ") + rate;
  if (!survey.frame.empty()) line += "  frame " + text::printable(survey.frame);
  if (!survey.content.empty()) line += "  " + text::printable(survey.content);
  return line;
}

std::string list(const std::vector<TopicSurvey>& topics) {
  std::string text;
  for (std::size_t i = 0; i < std::min(topics.size(), kMostListed); ++i) {
    text += '\n' + line_of(topics[i]);
  }
  if (topics.size() > kMostListed) {
    text += "\n  and " + std::to_string(topics.size() - kMostListed) + " more";
  }
  return text;
}

}  // namespace

double TopicSurvey::rate_hz() const {
  return messages < 2 || last_ns <= first_ns
             ? 0.0
             : static_cast<double>(messages - 1) / seconds(last_ns - first_ns);
}

std::string BagSurvey::metadata_topic_for(const std::string& topic) const {
  std::string best;
  std::ptrdiff_t most = -1;
  for (const auto& [name, text] : metadata) {
    const auto end = std::mismatch(name.begin(), name.end(), topic.begin(), topic.end()).first;
    if (end - name.begin() <= most) continue;
    most = end - name.begin();
    best = name;
  }
  return best;
}

std::string BagSurvey::metadata_for(const std::string& topic) const {
  const auto found = metadata.find(metadata_topic_for(topic));
  return found == metadata.end() ? std::string() : found->second;
}

BagSurvey survey_topics(MessageSource& bag, const OpenOptions& options) {
  BagSurvey found;
  std::vector<TopicSurvey>& topics = found.topics;
  std::map<std::pair<std::string, std::string>, std::size_t> places;  // of names and types
  std::optional<std::int64_t> begin_ns;
  bool any_usable = false;
  while (const std::optional<Message> message = bag.next()) {
    const std::string& type = message->topic->type;
    if (!begin_ns && (is_cloud_type(type) || is_packet_type(type))) begin_ns = message->logged_ns;
    const auto [place, is_new] =
        places.try_emplace({message->topic->name, message->topic->type}, topics.size());
    if (is_new) {
      if (topics.size() >= kMostTopics) {
        places.erase(place);
        continue;
      }
      topics.emplace_back();
      topics.back().topic = *message->topic;
      topics.back().first_ns = message->logged_ns;
    }
    TopicSurvey* const survey = &topics[place->second];
    ++survey->messages;
    survey->last_ns = message->logged_ns;
    take_metadata(*message, found);
    if (!survey->usable && survey->tried < kMostTried) {
      ++survey->tried;
      look_into(*message, options, found.metadata_for(survey->topic.name), *survey);
    }
    const bool is_asked = options.topic.empty() || survey->topic.name == options.topic;
    any_usable = any_usable || (is_asked && survey->usable);
    if (any_usable && message->logged_ns - *begin_ns > kLookedAtNs) break;
  }
  return found;
}

const TopicSurvey& choose_topic(const std::vector<TopicSurvey>& topics, const std::string& asked,
                                const std::string& bag) {
  std::vector<TopicSurvey> usable;
  const TopicSurvey* chosen = nullptr;
  for (const TopicSurvey& survey : topics) {
    if (survey.topic.name == asked) chosen = &survey;
    if (survey.usable) usable.push_back(survey);
  }
  if (!asked.empty()) {
    if (chosen == nullptr) {
      throw ReadError(bag + ": no topic '" + asked + "'; there are:" + list(topics));
    }
    if (!chosen->usable) {
      throw ReadError(bag + ": no scans can be made of" + line_of(*chosen));
    }
    return *chosen;
  }
  if (usable.empty()) {
    throw ReadError(bag +
                    ": no topic that scans can be made of (sensor_msgs/PointCloud2 and others)" +
                    (topics.empty() ? "; it holds no message" : "; there are:" + list(topics)));
  }
  if (usable.size() > 1) {
    std::string text = bag + ": " + std::to_string(usable.size()) +
                       " topics that scans can be made of:" + list(usable) +
                       "\ntake one, by the same command with:";
    for (const TopicSurvey& survey : usable) {
      text += "\n  --topic " + text::shell_word(survey.topic.name);
    }
    throw ReadError(text);
  }
  for (const TopicSurvey& survey : topics) {
    if (survey.usable) chosen = &survey;
  }
  return *chosen;
}

}  // namespace surefoot::io
