// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "ros2/topic_network.hpp"

#include <optional>
#include <utility>

#include "ros2/command_server.hpp"
#include "ros2/topic_publisher.hpp"
#include "ros2/topic_subscription.hpp"

namespace surefoot::ros2 {
namespace {

class Domain final : public live::TopicNetwork {
 public:
  Domain(const ParticipantOptions& options, bool reliable)
      : participant_(std::make_shared<Participant>(options)), reliable_(reliable) {}

  std::unique_ptr<live::TopicSource> subscribe(
      const std::string& topic, std::function<void(const std::string&)> say) override {
    return ros2::subscribe(participant_, {topic, reliable_, std::move(say)});
  }
  std::unique_ptr<io::BagWriter> publisher() override { return publish(participant_); }
  void serve(const std::vector<std::string>& commands, Handler handler) override {
    server_.emplace(participant_, commands, std::move(handler));
  }

 private:
  std::shared_ptr<Participant> participant_;
  bool reliable_;
  std::optional<CommandServer> server_;
};

}  // namespace

std::unique_ptr<live::TopicNetwork> join_domain(const ParticipantOptions& options, bool reliable) {
  return std::make_unique<Domain>(options, reliable);
}

}  // namespace surefoot::ros2
