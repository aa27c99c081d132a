// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "ros1/topic_network.hpp"

#include <optional>
#include <utility>

#include "ros1/topic_publisher.hpp"
#include "ros1/topic_subscription.hpp"
#include "ros1/trigger_services.hpp"

namespace surefoot::ros1 {
namespace {

class Graph final : public live::TopicNetwork {
 public:
  explicit Graph(const NodeOptions& options) : node_(std::make_shared<Node>(options)) {}

  std::unique_ptr<live::TopicSource> subscribe(
      const std::string& topic, std::function<void(const std::string&)> say) override {
    return ros1::subscribe(node_, topic, std::move(say));
  }
  std::unique_ptr<io::BagWriter> publisher() override { return publish(node_); }
  void serve(const std::vector<std::string>& commands, Handler handler) override {
    services_.emplace(node_, commands, std::move(handler));
  }

 private:
  std::shared_ptr<Node> node_;
  std::optional<TriggerServices> services_;
};

}  // namespace

std::unique_ptr<live::TopicNetwork> join_master(const NodeOptions& options) {
  return std::make_unique<Graph>(options);
}

}  // namespace surefoot::ros1
