// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "live/live_recording.hpp"

#include <algorithm>
#include <utility>

#include "io/packets/datagram_writer.hpp"

namespace surefoot::live {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMostLatencies = 100'000;

double milliseconds(Clock::duration span) {
  return std::chrono::duration<double, std::milli>(span).count();
}

}  // namespace

LiveRecording::LiveRecording(std::unique_ptr<DatagramSource> source, LiveOptions options)
    : source_(std::move(source)),
      options_(std::move(options)),
      writer_(options_.record.empty() ? nullptr
                                      : std::make_unique<io::DatagramWriter>(options_.record)),
      intake_(options_.reader, options_.metadata),
      thread_([this] { run(); }) {}

LiveRecording::~LiveRecording() {
  {
    const std::lock_guard lock(mutex_);
    abandoned_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void LiveRecording::run() {
  std::exception_ptr failure;
  try {
    receive_all();
    if (writer_) writer_->flush();
    if (figures().packets.data_packets == 0) throw io::ReadError(nothing_text());
  } catch (...) {
    failure = std::current_exception();
  }
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
    failure_ = failure;
  }
  changed_.notify_all();
}

std::string LiveRecording::nothing_text() const {
  const std::lock_guard lock(mutex_);
  return source_->name() + ": " + std::to_string(figures_.datagrams) +
         " datagrams, no LiDAR's data packet" + intake_.port_text() + " among them" +
         (figures_.datagrams > 0 ? intake_.traffic_seen() : std::string());
}

void LiveRecording::receive_all() {
  Arrival arrival;
  Clock::time_point last;
  bool any = false;
  while (!options_.stopped || !options_.stopped()) {
    {
      const std::lock_guard lock(mutex_);
      if (abandoned_) return;
      figures_.overflowed = source_->overflowed();
    }
    const Received received = source_->receive(arrival);
    if (received == Received::kEnd) break;
    if (received == Received::kDatagram) {
      any = true;
      last = arrival.received;
      use(arrival);
    } else if (any && is_silent(last)) {
      break;
    }
  }
  {
    const std::lock_guard lock(mutex_);
    intake_.scans().finish();
  }
  take_scans(last);
  describe();
}

bool LiveRecording::is_silent(Clock::time_point last) const {
  return options_.silence > 0.0 && milliseconds(Clock::now() - last) > 1e3 * options_.silence;
}

void LiveRecording::use(const Arrival& arrival) {
  if (writer_) writer_->add(arrival.arrival_ns, arrival.datagram);
  {
    const std::lock_guard lock(mutex_);
    ++figures_.datagrams;
    intake_.add(arrival.arrival_ns, arrival.datagram);
  }
  take_scans(arrival.received);
}

void LiveRecording::take_scans(Clock::time_point received) {
  std::unique_lock lock(mutex_);
  while (std::optional<io::ScanItem> item = intake_.scans().take()) {
    enqueue({std::move(*item), received}, lock);
    if (writer_) writer_->flush();
  }
}

void LiveRecording::enqueue(Waiting waiting, std::unique_lock<std::mutex>& lock) {
  const auto is_full = [&] { return queue_.size() >= std::max<std::size_t>(options_.queue, 1); };
  if (source_->patient()) changed_.wait(lock, [&] { return !is_full() || abandoned_; });
  while (is_full()) {
    const io::ScanItem& oldest = queue_.front().item;
    log_.dropped(oldest.scan->stamp_ns, oldest.name);
    ++figures_.dropped;
    queue_.pop_front();
  }
  queue_.push_back(std::move(waiting));
  notes_ = intake_.scans().notes();
  changed_.notify_all();
}

/// What is known at the end only.
void LiveRecording::describe() {
  const std::lock_guard lock(mutex_);
  notes_ = intake_.scans().notes();
  if (intake_.scans().lost() > 0) {
    notes_.push_back("by the sensor's clock " + std::to_string(intake_.scans().lost()) +
                     " data packets are missing");
  }
  if (figures_.overflowed > 0) {
    notes_.push_back(std::to_string(figures_.overflowed) +
                     " datagrams were lost because the socket was full");
  }
}

std::optional<io::ScanItem> LiveRecording::next() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return !queue_.empty() || ended_; });
  if (queue_.empty()) {
    if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
    return std::nullopt;
  }
  Waiting first = std::move(queue_.front());
  queue_.pop_front();
  changed_.notify_all();
  given_ = {first.item.scan->stamp_ns, first.item.name, first.received};
  return std::move(first.item);
}

void LiveRecording::skip(std::size_t scans) {
  while (scans > 0 && next()) --scans;
}

void LiveRecording::done() {
  if (!given_) return;
  const double latency_ms = milliseconds(Clock::now() - given_->received);
  log_.used(given_->stamp_ns, given_->name, latency_ms);
  given_.reset();
  const std::lock_guard lock(mutex_);
  ++figures_.used;
  std::vector<double>& latencies = figures_.latencies_ms;
  if (latencies.size() < kMostLatencies) {
    latencies.push_back(latency_ms);
  } else {
    latencies[next_latency_++ % kMostLatencies] = latency_ms;
  }
}

const std::vector<std::string>& LiveRecording::notes() const {
  const std::lock_guard lock(mutex_);
  notes_given_ = notes_;
  return notes_given_;
}

std::string LiveRecording::description() const {
  const std::lock_guard lock(mutex_);
  return intake_.scans().sensor() + " live from " + source_->name() + ", return mode " +
         intake_.scans().return_mode();
}

LiveFigures LiveRecording::figures() const {
  const std::lock_guard lock(mutex_);
  LiveFigures figures = figures_;
  figures.packets = intake_.counts();
  figures.packets.packets = figures_.datagrams;
  return figures;
}

}  // namespace surefoot::live
