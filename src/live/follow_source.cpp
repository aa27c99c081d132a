// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A capture or a bag that somebody else is still writing. It is opened once something is asked for:
// what tells its kind and its topic may not be there yet.
#include <algorithm>
#include <optional>
#include <thread>
#include <utility>

#include "io/bags/bag_recording.hpp"
#include "io/bags/mcap_reader.hpp"
#include "io/bags/ros1_bag_reader.hpp"
#include "io/bags/topic_survey.hpp"
#include "io/file_kind.hpp"
#include "live/captured_datagrams.hpp"
#include "live/datagram_source.hpp"
#include "live/followed_file.hpp"
#include "live/topic_source.hpp"

namespace surefoot::live {
namespace {

namespace fs = std::filesystem;

/// rosbag goes back to a chunk's head once the chunk is full, at 768 KiB and a message that may be
/// large.
constexpr std::uint64_t kChunkBeingWritten = 8 << 20;

/// Runs `open`, of whose errors the reader should know the file.
template <typename Open>
auto opened(const fs::path& file, const Open& open) {
  try {
    return open();
  } catch (const io::ReadError& error) {
    throw io::ReadError(file.string() + ": " + error.what());
  }
}

class FollowedCapture final : public DatagramSource {
 public:
  explicit FollowedCapture(fs::path file)
      : name_(std::move(file)), bytes_(opened(name_, [this] {
          return std::make_unique<FollowedFile>(name_, [this] { return (*go_on_)(); });
        })) {}

  Received receive(Arrival& arrival) override {
    if (bytes_) {
      opened(name_, [this] { datagrams_.emplace(io::CaptureFile(std::move(bytes_))); });
    }
    const std::optional<Arrival> next = datagrams_->next();
    if (!next) return Received::end;
    arrival = *next;
    arrival.received = std::chrono::steady_clock::now();
    return Received::something;
  }
  void ask(const std::function<bool()>& go_on) override { go_on_ = &go_on; }
  bool patient() const override { return true; }
  std::string name() const override { return name_.string(); }
  std::string ended_early() const override {
    // Told to stop, it may stop within a packet.
    return datagrams_ && (*go_on_)() ? datagrams_->cut_short() : std::string();
  }

 private:
  fs::path name_;
  const std::function<bool()>* go_on_ = nullptr;
  std::unique_ptr<FollowedFile> bytes_;  ///< until it is read
  std::optional<CapturedDatagrams> datagrams_;
};

class FollowedBag final : public TopicSource {
 public:
  FollowedBag(fs::path file, io::OpenOptions options)
      : name_(std::move(file)), options_(std::move(options)) {
    opened(name_, [this] { (void)bytes(); });
  }

  Received receive(TopicArrival& arrival) override {
    if (!bag_ && !find_topic()) return Received::nothing;
    const std::optional<io::Message> message = bag_->parts.messages.next();
    if (!message) return Received::end;
    arrival.bytes.assign(message->bytes.begin(), message->bytes.end());
    arrival.arrival_ns = message->logged_ns;
    arrival.received = std::chrono::steady_clock::now();
    return Received::something;
  }
  void ask(const std::function<bool()>& go_on) override { go_on_ = &go_on; }
  const io::Topic& topic() const override { return bag_->topic; }
  std::string calibration() const override { return bag_->calibration; }
  bool patient() const override { return true; }
  std::string name() const override { return name_.string(); }

 private:
  /// What is there is looked at, and again when it has grown, until there is a topic of scans.
  bool find_topic() {
    constexpr std::chrono::milliseconds kLookAgain(50);
    const std::uintmax_t size = fs::file_size(name_);
    if (size < io::kTellingBytes || size == looked_at_) {
      std::this_thread::sleep_for(kLookAgain);
      return false;
    }
    looked_at_ = size;
    const std::unique_ptr<io::MessageSource> first = messages();
    const io::BagSurvey survey = io::survey_topics(*first, options_);
    const bool any =
        std::any_of(survey.topics.begin(), survey.topics.end(), [this](const io::TopicSurvey& one) {
          return one.usable && (options_.topic.empty() || options_.topic == one.topic.name);
        });
    if (!any) return false;
    bag_.emplace(io::open_bag_topic(io::TopicMessages([this] { return messages(); }),
                                    name_.string(), options_));
    waits_ = true;
    bag_->parts.messages.begin(bag_->topic);
    return true;
  }

  [[nodiscard]] std::unique_ptr<FollowedFile> bytes() const {
    return std::make_unique<FollowedFile>(
        name_, [this] { return waits_ && (*go_on_)(); }, kChunkBeingWritten);
  }
  [[nodiscard]] std::unique_ptr<io::MessageSource> messages() const {
    return opened(name_, [this] {
      return io::kind_of(name_) == io::FileKind::ros1_bag ? io::read_ros1_bag(bytes())
                                                          : io::read_mcap(bytes());
    });
  }

  fs::path name_;
  io::OpenOptions options_;
  const std::function<bool()>* go_on_ = nullptr;
  std::uintmax_t looked_at_ = 0;
  bool waits_ = false;
  std::optional<io::BagTopic> bag_;
};

}  // namespace

std::unique_ptr<DatagramSource> follow_capture(const fs::path& file) {
  return std::make_unique<FollowedCapture>(file);
}

std::unique_ptr<TopicSource> follow_bag(const fs::path& file, const io::OpenOptions& options) {
  if (io::kind_of(file) == io::FileKind::sqlite_bag) {
    throw io::ReadError(file.string() +
                        ": a database is not followed; expected a capture, MCAP or a ROS 1 bag");
  }
  return std::make_unique<FollowedBag>(file, options);
}

}  // namespace surefoot::live
