// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "ros2/command_server.hpp"

#include <dds/dds.h>
#include <dds/ddsi/ddsi_serdata.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "io/messages/message_reader.hpp"
#include "io/messages/message_writer.hpp"
#include "io/recording.hpp"
#include "ros2/raw_type.hpp"

namespace surefoot::ros2 {
namespace {

constexpr const char* kPrefix = "/surefoot/";
constexpr TopicQos kQos = {.depth = 10};

std::vector<std::vector<std::byte>> take_all(const Participant::Endpoint& reader) {
  std::vector<std::vector<std::byte>> messages;
  ddsi_serdata* sample = nullptr;
  dds_sample_info_t info;
  while (dds_takecdr(reader.entity, &sample, 1, &info, DDS_ANY_STATE) == 1) {
    if (info.valid_data) messages.push_back(copy_raw_sample(sample).bytes);
    ddsi_serdata_unref(sample);
  }
  return messages;
}

/// Who asked may not have been found yet by who answers it; others that have been found do not
/// count for it. Everybody has a writer of requests and a reader of replies.
void wait_for_readers(const Participant::Endpoint& replies, const Participant::Endpoint& requests) {
  constexpr int kTries = 200;
  for (int i = 0; i < kTries; ++i) {
    const dds_return_t asking = dds_get_matched_publications(requests.entity, nullptr, 0);
    const dds_return_t hearing = dds_get_matched_subscriptions(replies.entity, nullptr, 0);
    if (hearing >= std::max(asking, 1)) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

}  // namespace

CommandServer::CommandServer(std::shared_ptr<Participant> participant,
                             const std::vector<std::string>& commands, Handler handler)
    : participant_(std::move(participant)), handler_(std::move(handler)) {
  waitset_ = dds_create_waitset(DDS_CYCLONEDDS_HANDLE);
  const auto attach = [this](const Participant::Endpoint& reader) {
    (void)dds_set_status_mask(reader.entity, DDS_DATA_AVAILABLE_STATUS);
    (void)dds_waitset_attach(waitset_, reader.entity, 0);
  };
  for (const std::string& command : commands) {
    const std::string name = kPrefix + command;
    services_.push_back({command, participant_->add_reader(trigger_request_topic(name), kQos),
                         participant_->add_writer(trigger_reply_topic(name), kQos)});
    attach(services_.back().requests);
  }
  topic_ = participant_->add_reader(
      message_topic(kPrefix + std::string("command"), "std_msgs/String"), kQos);
  attach(topic_);
  thread_ = std::thread([this] { serve(); });
}

CommandServer::~CommandServer() {
  stopped_ = true;
  thread_.join();
  (void)dds_delete(waitset_);
}

void CommandServer::serve() {
  while (!stopped_) {
    dds_attach_t attached = 0;
    (void)dds_waitset_wait(waitset_, &attached, 1, DDS_MSECS(100));
    for (const Service& service : services_) {
      for (const auto& request : take_all(service.requests)) answer(service, request);
    }
    for (const auto& message : take_all(topic_)) obey(message);
  }
}

void CommandServer::answer(const Service& service, const std::vector<std::byte>& request) const {
  try {
    io::MessageReader reader(io::MessageEncoding::cdr, request);
    const auto client = reader.number<std::uint64_t>("client");
    const auto number = reader.number<std::int64_t>("number");
    const live::CommandAnswer answer = handler_(service.command);
    io::MessageWriter reply;
    reply.number(client).number(number);
    reply.number(static_cast<std::uint8_t>(answer.done ? 1 : 0)).string(answer.text);
    wait_for_readers(service.replies, service.requests);
    (void)Participant::write(service.replies, reply.take());
  } catch (const io::ReadError&) {  // no request
  }
}

void CommandServer::obey(const std::vector<std::byte>& message) const {
  try {
    io::MessageReader reader(io::MessageEncoding::cdr, message);
    const std::string command(reader.string("command"));
    const std::string name = command.substr(0, command.find(' '));  // a map's may follow
    const bool known = std::any_of(services_.begin(), services_.end(),
                                   [&](const Service& one) { return one.command == name; });
    if (known) (void)handler_(command);
  } catch (const io::ReadError&) {
  }
}

}  // namespace surefoot::ros2
