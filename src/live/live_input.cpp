// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "live/live_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "io/bags/bag_files.hpp"
#include "io/datasets.hpp"
#include "io/idle_options.hpp"
#include "io/packets/metadata_file.hpp"
#include "io/robots.hpp"

namespace surefoot::live {
namespace {

namespace fs = std::filesystem;

/// That is played or grows; empty: none.
const fs::path& file_of(const LiveSource& source) {
  return source.follow.empty() ? source.replay : source.follow;
}

/// What is not recorded has a name, but cannot be opened again.
void name_input(LiveInput& input, const LiveSource& source, const std::string& name) {
  input.is_kept = !source.record.empty();
  input.path = input.is_kept ? source.record : fs::path(name);
}

void open_packets(LiveInput& input, const LiveSource& source, const io::OpenOptions& reader) {
  input.repeated_by.emplace_back("repair-stamps", "false");  // which would wait for two scans
  if (const fs::path& file = file_of(source); !file.empty()) {
    input.stream = packet_stream(
        source.follow.empty() ? replay_capture(file, source.speed) : follow_capture(file), reader,
        io::metadata_beside(file).text, source.record);
    return;
  }
  name_input(input, source, fmt::format("udp-{}", source.udp));
  input.stream = packet_stream(listen_udp(source.address, source.udp), reader, "", source.record);
}

/// The reader's options for messages; what repeats them is noted.
io::OpenOptions topic_options(LiveInput& input, const io::OpenOptions& reader) {
  input.of_topic = true;
  if (!reader.repair_at_once) input.repeated_by.emplace_back("repair-at-once", "true");
  return io::with_robot(io::with_dataset(reader));
}

bool is_bag(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored) ? !io::bag_files(path).empty() : io::is_bag_file(path);
}

/// A topic is named by the network that it is of, and recorded as that network has it.
void open_topic(LiveInput& input, const LiveSource& source, const io::OpenOptions& reader,
                const std::function<void(const std::string&)>& say) {
  const TopicRequest& request = source.topics;
  if (!source.record.empty() && source.record.extension() != request.extension) {
    throw std::invalid_argument(
        fmt::format("live: --record of a topic expects FILE{}", request.extension));
  }
  std::string name = request.network + request.topic;
  std::replace(name.begin(), name.end(), '/', '-');
  name_input(input, source, name);
  const io::OpenOptions options = topic_options(input, reader);
  // Who repeats it with the same robot must not look for that one's own topic.
  if (!reader.robot.empty()) input.repeated_by.emplace_back("topic", request.topic);
  input.stream = topic_stream(input.network->subscribe(request.topic, say), options, source.record);
}

/// Of a topic nothing says yet whether its messages are clouds or packets.
std::vector<std::string> idle_options(const io::OpenOptions& reader, bool of_topic) {
  std::vector<std::string> notes = io::idle_options(reader, {of_topic, true});
  if (!of_topic) return notes;
  const std::vector<std::string> of_clouds = io::idle_options(reader, {true, false});
  std::erase_if(notes, [&](const std::string& note) {
    return std::find(of_clouds.begin(), of_clouds.end(), note) == of_clouds.end();
  });
  return notes;
}

void join(LiveInput& input, const TopicRequest& request, CommandQueue& commands) {
  input.network = request.join();
  if (request.publish) input.messages = input.network->publisher();
  if (request.commands) {
    input.network->serve({"reset", "pause", "resume", "save_map", "localize"},
                         [&commands](const std::string& command) { return commands.ask(command); });
  }
}

/// A file that is played or grows, or a socket.
void open_file_or_packets(LiveInput& input, const LiveSource& source,
                          const io::OpenOptions& reader) {
  const fs::path& file = file_of(source);
  std::error_code ignored;
  if (fs::is_regular_file(file, ignored) || fs::is_directory(file, ignored)) {
    input.path = file;
    input.is_kept = true;
  } else if (!file.empty()) {
    name_input(input, source, file.filename().string());  // what comes through a pipe
  }
  if (is_bag(file)) {
    const io::OpenOptions options = topic_options(input, reader);
    input.stream = topic_stream(
        source.follow.empty() ? replay_bag(file, options, source.speed) : follow_bag(file, options),
        options, {});
  } else {
    open_packets(input, source, reader);
  }
}

}  // namespace

LiveInput open_live_input(const LiveSource& source, const io::OpenOptions& reader,
                          CommandQueue& commands,
                          const std::function<void(const std::string&)>& say) {
  LiveInput input;
  if (source.topics.any()) join(input, source.topics, commands);
  if (source.topics.topic.empty()) {
    open_file_or_packets(input, source, reader);
  } else {
    open_topic(input, source, reader, say);
  }
  for (const std::string& note : idle_options(reader, input.of_topic)) say(note);
  return input;
}

}  // namespace surefoot::live
