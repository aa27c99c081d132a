// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "ros2/cyclone_log.hpp"

#include <dds/dds.h>
#include <dds/ddsrt/log.h>

#include <atomic>
#include <cstdio>
#include <string_view>

namespace surefoot::ros2 {
namespace {

std::atomic<std::uint64_t> refused{0};

void add(void* self, const dds_log_data_t* data) {
  auto& text = *static_cast<std::string*>(self);
  if (!text.empty()) text += "; ";
  text.append(data->message, data->size);
  while (text.ends_with('\n')) text.pop_back();
}

void count_or_print(void*, const dds_log_data_t* data) {
  const std::string_view text(data->message, data->size);
  if (text.find("malformed packet received") != std::string_view::npos) {
    ++refused;
  } else {
    (void)std::fwrite(text.data(), 1, text.size(), stderr);
  }
}

}  // namespace

Complaints::Complaints() {
  dds_set_log_sink(add, &text_);
  dds_set_trace_sink(add, &text_);
}

Complaints::~Complaints() {
  dds_set_log_sink(count_or_print, nullptr);
  dds_set_trace_sink(nullptr, nullptr);
}

std::uint64_t refused_packets() { return refused; }

}  // namespace surefoot::ros2
