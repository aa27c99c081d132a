// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Messages of a topic go the way that a bag's go: what it was live is what its record gives.
#include <deque>
#include <utility>

#include "io/bags/bag_writer.hpp"
#include "io/bags/topic_recordings.hpp"
#include "io/messages/cloud_message.hpp"
#include "io/messages/packet_message.hpp"
#include "io/point_time_watch.hpp"
#include "io/stamp_repair.hpp"
#include "live/scan_stream.hpp"

namespace surefoot::live {
namespace {

using Clock = std::chrono::steady_clock;

/// All messages, in a file that a run can be repeated from.
class TopicRecord {
 public:
  explicit TopicRecord(const std::filesystem::path& file)
      : bag_(file.extension() == ".bag" ? io::make_ros1_bag(file) : io::make_mcap_bag(file)) {}

  void add(const TopicSource& source, const TopicArrival& arrival) {
    if (!known_) {
      topic_ = bag_->add_topic(source.topic().name, source.definition());
      known_ = true;
    }
    bag_->write(topic_, arrival.arrival_ns,
                std::string_view(reinterpret_cast<const char*>(arrival.bytes.data()),
                                 arrival.bytes.size()));
  }
  void finish() { bag_->finish(); }

 private:
  std::unique_ptr<io::BagWriter> bag_;
  std::size_t topic_ = 0;
  bool known_ = false;
};

/// A source's messages as if they were a bag's. The first ones are kept until they were looked at.
class LiveMessages final : public io::MessageSource {
 public:
  LiveMessages(std::unique_ptr<TopicSource> source, const std::filesystem::path& record)
      : source_(std::move(source)),
        record_(record.empty() ? nullptr : std::make_unique<TopicRecord>(record)) {}

  std::optional<io::Message> next() override {
    if (next_kept_ == kept_.size()) {
      if (!receive()) return std::nullopt;
    }
    if (keeps_) return message_of(kept_[next_kept_++]);
    given_ = std::move(kept_.front());
    kept_.pop_front();
    return message_of(given_);
  }
  bool rewind() override {
    next_kept_ = 0;
    return true;
  }
  double progress() const override { return 0.0; }
  std::string format() const override { return "live from " + source_->name(); }

  /// Whether there is a first message, which tells the topic.
  bool wait() { return !kept_.empty() || receive(); }
  /// From here on what was given is forgotten.
  void keep_no_more() {
    kept_.erase(kept_.begin(), kept_.begin() + static_cast<std::ptrdiff_t>(next_kept_));
    next_kept_ = 0;
    keeps_ = false;
  }
  void ask(const std::function<bool()>& go_on) {
    go_on_ = &go_on;
    source_->ask(go_on);
  }
  void finish() {
    if (record_) record_->finish();
    record_.reset();
  }
  [[nodiscard]] const TopicSource& source() const { return *source_; }
  [[nodiscard]] std::size_t messages() const { return messages_; }
  [[nodiscard]] std::optional<Clock::time_point> last() const { return last_; }
  /// Of the message that was given last.
  [[nodiscard]] Clock::time_point received() const { return received_; }

 private:
  bool receive() {
    while (!ended_ && (*go_on_)()) {
      TopicArrival arrival;
      const Received received = source_->receive(arrival);
      ended_ = received == Received::end;
      if (received != Received::something) continue;
      ++messages_;
      last_ = arrival.received;
      if (record_) record_->add(*source_, arrival);
      if (keeps_) keep_within(arrival.bytes.size());
      kept_.push_back(std::move(arrival));
      return true;
    }
    ended_ = true;
    return false;
  }
  /// Nobody can tell yet whether what comes is of any use: a memory is not filled with it.
  void keep_within(std::size_t more) {
    constexpr std::size_t kMost = std::size_t{512} << 20;  // some forty of the densest scans
    kept_bytes_ += more;
    if (kept_bytes_ <= kMost) return;
    throw io::ReadError(source_->name() + ": no scan in the first " + std::to_string(messages_) +
                        " messages, " + std::to_string(kept_bytes_ >> 20) +
                        " MiB; expected clouds or packets of a known sensor");
  }
  io::Message message_of(const TopicArrival& arrival) {
    received_ = arrival.received;
    return {&source_->topic(), arrival.arrival_ns, arrival.bytes};
  }

  std::unique_ptr<TopicSource> source_;
  std::unique_ptr<TopicRecord> record_;
  const std::function<bool()>* go_on_ = nullptr;
  std::deque<TopicArrival> kept_;
  TopicArrival given_;
  std::size_t next_kept_ = 0;
  std::size_t kept_bytes_ = 0;
  std::size_t messages_ = 0;
  std::optional<Clock::time_point> last_;
  Clock::time_point received_;
  bool keeps_ = true;
  bool ended_ = false;
};

class TopicStream final : public ScanStream {
 public:
  TopicStream(std::unique_ptr<TopicSource> source, const io::OpenOptions& options,
              const std::filesystem::path& record)
      : owned_(std::make_unique<LiveMessages>(std::move(source), record)),
        messages_(owned_.get()),
        options_(options) {
    options_.repair_at_once = true;  // nobody waits for the next scans
  }

  std::optional<LiveScan> next(const std::function<bool()>& go_on) override {
    messages_->ask(go_on);
    if (!scans_) {
      if (!messages_->wait()) return std::nullopt;
      open();
    }
    std::optional<io::ScanItem> item = scans_->next();
    if (!item) {
      messages_->finish();
      return std::nullopt;
    }
    any_ = any_ || item->scan;
    if (!item->scan && first_error_.empty()) first_error_ = item->error;
    return LiveScan{std::move(*item), messages_->received()};
  }

  StreamState state() const override {
    StreamState state;
    state.received = messages_->messages();
    state.lost = messages_->source().lost();
    if (!scans_) return state;
    state.packets = scans_->capture_counts();
    state.notes = scans_->notes();
    state.description = scans_->description();
    return state;
  }
  std::optional<Clock::time_point> last() const override { return messages_->last(); }
  bool patient() const override { return messages_->source().patient(); }
  std::string nothing_text() const override {
    if (any_) return {};
    if (!first_error_.empty()) return first_error_;
    const std::string name = messages_->source().name();
    return name + ": " + std::to_string(messages_->messages()) + " messages, no scan among them" +
           messages_->source().others();
  }

 private:
  void open() {
    const io::Topic topic = messages_->source().topic();
    const std::string calibration = messages_->source().calibration();
    io::TopicRecordingParts parts{
        messages_->source().name(), io::TopicMessages(std::move(owned_)), {}, {}};
    std::unique_ptr<io::Recording> scans =
        io::is_packet_type(topic.type)
            ? io::open_packet_topic(std::move(parts), topic, options_, calibration)
            : io::open_cloud_topic(std::move(parts), topic, options_);
    messages_->keep_no_more();
    scans = io::watch_point_times(std::move(scans), options_);
    scans_ =
        options_.repair_stamps ? io::repair_stamps(std::move(scans), options_) : std::move(scans);
  }

  std::unique_ptr<LiveMessages> owned_;  ///< until it is opened
  LiveMessages* messages_;
  io::OpenOptions options_;
  std::unique_ptr<io::Recording> scans_;
  std::string first_error_;
  bool any_ = false;
};

}  // namespace

std::unique_ptr<ScanStream> topic_stream(std::unique_ptr<TopicSource> source,
                                         const io::OpenOptions& options,
                                         const std::filesystem::path& record) {
  return std::make_unique<TopicStream>(std::move(source), options, record);
}

}  // namespace surefoot::live
