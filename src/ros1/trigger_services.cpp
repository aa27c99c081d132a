// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// In C++17: see message_types.cpp.
#include "ros1/trigger_services.hpp"

#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>

#include <utility>

namespace surefoot::ros1 {

struct TriggerServices::Servers {
  ros::CallbackQueue queue;
  std::vector<ros::ServiceServer> servers;
  ros::AsyncSpinner spinner{1, &queue};
};

TriggerServices::TriggerServices(std::shared_ptr<Node> node,
                                 const std::vector<std::string>& commands, Handler handler)
    : node_(std::move(node)), handler_(std::move(handler)), servers_(std::make_unique<Servers>()) {
  using Request = std_srvs::Trigger::Request;
  using Response = std_srvs::Trigger::Response;
  for (const std::string& command : commands) {
    auto options = ros::AdvertiseServiceOptions::create<std_srvs::Trigger>(
        "/surefoot/" + command,
        [this, command](Request& /*request*/, Response& response) {
          const live::CommandAnswer answer = handler_(command);
          response.success = answer.done;
          response.message = answer.text;
          return true;
        },
        ros::VoidPtr(), &servers_->queue);
    servers_->servers.push_back(node_->handle().advertiseService(options));
  }
  servers_->spinner.start();
}

TriggerServices::~TriggerServices() { servers_->spinner.stop(); }

}  // namespace surefoot::ros1
