// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "live/live_recording.hpp"

#include <algorithm>
#include <utility>

namespace surefoot::live {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMostLatencies = 100'000;

double milliseconds(Clock::duration span) {
  return std::chrono::duration<double, std::milli>(span).count();
}

}  // namespace

LiveRecording::LiveRecording(std::unique_ptr<ScanStream> stream, LiveOptions options)
    : stream_(std::move(stream)), options_(std::move(options)), thread_([this] { run(); }) {}

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

void LiveRecording::receive_all() {
  while (std::optional<LiveScan> scan = stream_->next([this] { return goes_on(); })) {
    take_state();
    enqueue(std::move(*scan));
  }
  take_state();
  if (const std::string text = stream_->nothing_text(); !text.empty()) throw io::ReadError(text);
}

bool LiveRecording::goes_on() {
  if (options_.stopped && options_.stopped()) return false;
  const std::optional<Clock::time_point> last = stream_->last();
  if (last && options_.silence > 0.0 &&
      milliseconds(Clock::now() - *last) > 1e3 * options_.silence) {
    return false;
  }
  const std::lock_guard lock(mutex_);
  return !abandoned_;
}

void LiveRecording::take_state() {
  StreamState state = stream_->state();
  const std::lock_guard lock(mutex_);
  for (; stream_notes_ < state.notes.size(); ++stream_notes_) {
    notes_.push_back(state.notes[stream_notes_]);
  }
  state_ = std::move(state);
}

void LiveRecording::enqueue(LiveScan scan) {
  std::unique_lock lock(mutex_);
  if (!scan.item.scan) {
    if (figures_.unreadable++ == 0) notes_.push_back("left out: " + scan.item.error);
    return;
  }
  last_scan_ = Clock::now();
  if (paused_) {
    log_.paused(scan.item.scan->stamp_ns, scan.item.name);
    ++figures_.paused;
    return;
  }
  const auto is_full = [&] { return queue_.size() >= std::max<std::size_t>(options_.queue, 1); };
  if (stream_->patient()) changed_.wait(lock, [&] { return !is_full() || abandoned_; });
  while (is_full()) {
    const io::ScanItem& oldest = queue_.front().item;
    log_.dropped(oldest.scan->stamp_ns, oldest.name);
    ++figures_.dropped;
    queue_.pop_front();
  }
  queue_.push_back(std::move(scan));
  changed_.notify_all();
}

std::optional<io::ScanItem> LiveRecording::next() {
  std::unique_lock lock(mutex_);
  constexpr std::chrono::milliseconds kIdlePeriod(100);
  while (!changed_.wait_for(lock, kIdlePeriod, [this] { return !queue_.empty() || ended_; })) {
    if (!options_.idle) continue;
    lock.unlock();
    options_.idle();
    lock.lock();
  }
  if (queue_.empty()) {
    lock.unlock();
    if (!has_given_) rethrow_failure();
    return std::nullopt;
  }
  has_given_ = true;
  LiveScan first = std::move(queue_.front());
  queue_.pop_front();
  changed_.notify_all();
  given_ = {first.item.scan->stamp_ns, first.item.name, first.received, std::nullopt};
  return std::move(first.item);
}

void LiveRecording::rethrow_failure() {
  const std::lock_guard lock(mutex_);
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

void LiveRecording::skip(std::size_t scans) {
  while (scans > 0 && next()) --scans;
}

void LiveRecording::pause(bool paused) {
  const std::lock_guard lock(mutex_);
  paused_ = paused;
}

void LiveRecording::answered() {
  if (given_) given_->answered = Clock::now();
}

double LiveRecording::done() {
  if (!given_) return 0.0;
  const Clock::time_point answered = given_->answered.value_or(Clock::now());
  const double latency_ms = milliseconds(answered - given_->received);
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
  return latency_ms;
}

const std::vector<std::string>& LiveRecording::notes() const {
  const std::lock_guard lock(mutex_);
  notes_given_ = notes_;
  return notes_given_;
}

std::string LiveRecording::description() const {
  const std::lock_guard lock(mutex_);
  return state_.description;
}

LiveFigures LiveRecording::figures() const {
  const std::lock_guard lock(mutex_);
  LiveFigures figures = figures_;
  figures.received = state_.received;
  figures.lost = state_.lost;
  figures.packets = state_.packets;
  figures.is_paused = paused_;
  figures.silent_s = milliseconds(Clock::now() - last_scan_) / 1e3;
  return figures;
}

}  // namespace surefoot::live
