// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Hours of a sensor, as fast as they are used: live_soak [HOURS] [ONE_RETURN_OF] [FILE.csv]
//
// A VLP-16 that stands in a hall sends to `surefoot live` over the loopback interface, ten
// revolutions a simulated second. Spread over the hours, however many, it is switched off and on a
// thousand times, and a million datagrams that are no sensor's come between. Of its returns one of
// ONE_RETURN_OF is there, so that a scan is registered sooner; packets and their number are whole.
// Says how much memory was taken meanwhile, and ends with 1 where anything was lost, dropped or not
// trusted, or where memory is not flat. SIGINT ends it early, and what was sent is judged. Where
// the sender itself is stopped, its stamps go on as if it had not been, which no sensor's do: the
// scan under way is cut in two, and the parts need not be measured.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <thread>

#include "capture.hpp"
#include "process.hpp"
#include "soak.hpp"

namespace surefoot::test {
namespace {

constexpr std::size_t kReconnects = 1000;
constexpr std::size_t kMalformed = 1'000'000;
constexpr std::size_t kSamples = 96;
/// By how much memory may grow after the first quarter [B], whatever the hours: the picture's path
/// is full after one hour, the lists of times after three; and what it goes up and down by.
constexpr double kMostBytes = 3e6;

/// So many revolutions' packets fit a whole number of turns to 0.003 packets, and are sent again
/// and again, with the sensor's time going on.
constexpr int kRevolutions = 71;
constexpr std::size_t kPackets = 5350;
constexpr double kPacketUs = 1327.104;
constexpr double kPacketsPerRevolution = 1e5 / kPacketUs;

/// Longer between two packets: somebody stopped the sender, or the program that it waits for. Two
/// seconds would be the sensor's clock set back.
constexpr std::chrono::seconds kPause(1);

/// Asked to end early: what was sent so far is judged.
volatile std::sig_atomic_t is_stopped = 0;

/// Without returns but each `one_of`-th.
void thin(std::string& packet, std::size_t one_of) {
  std::size_t number = 0;
  for (std::size_t block = 0; block < 12; ++block) {
    for (std::size_t channel = 0; channel < 32; ++channel, ++number) {
      const std::size_t at = block * 100 + 4 + channel * 3;
      if (number % one_of != 0) packet[at] = packet[at + 1] = '\0';
    }
  }
}

/// The sensor's time past the hour.
void stamp(std::string& packet, std::size_t index) {
  const double us = std::fmod(kPacketUs * static_cast<double>(index), 3.6e9);
  const auto whole = static_cast<std::uint32_t>(us);
  for (std::size_t i = 0; i < 4; ++i) packet[1200 + i] = static_cast<char>(whole >> (8 * i));
}

/// The lines of a file that grows, each seen once.
class Follower {
 public:
  explicit Follower(std::filesystem::path file) : path_(std::move(file)) {}
  [[nodiscard]] std::size_t lines() {
    if (!file_.is_open()) file_.open(path_);
    if (!file_.is_open()) return 0;
    file_.clear();
    char buffer[65536];
    do {
      file_.read(buffer, sizeof(buffer));
      const std::streamsize size = file_.gcount();
      lines_ += static_cast<std::size_t>(std::count(buffer, buffer + size, '\n'));
    } while (file_);
    return lines_;
  }

 private:
  std::filesystem::path path_;
  std::ifstream file_;
  std::size_t lines_ = 0;
};

struct Sample {
  double hours = 0.0;
  std::size_t scans = 0, datagrams = 0, memory_kb = 0, pauses = 0;
};

class Soak {
 public:
  Soak(double hours, std::size_t one_return_of)
      : total_(static_cast<std::size_t>(hours * 3.6e9 / kPacketUs)),
        silence_(hours > 1.0 ? "600" : "30"),  // a stopped sender is no end of a long run
        random_(11),
        packets_(vlp16_packets(kRevolutions)) {
    packets_.resize(kPackets);
    malformed_ = malformed_datagrams(packets_, random_);
    for (std::string& packet : packets_) thin(packet, one_return_of);
  }

  /// False where something is not as it should be.
  bool run() {
    Surroundings patient;
    patient.most_seconds = 86'400;
    const Process process({"live", "--udp", sender_.port(), "-o", "live", "--queue", "1000",
                           "--silence", silence_, "--no-report"},
                          scratch_.path(), patient);
    if (!sender_.wait_for_listener()) return false;
    const std::size_t planned = total_;
    for (std::size_t i = 0; i < planned; ++i) {
      if (is_stopped != 0 && i > kPackets) {
        total_ = i;
        break;
      }
      disturb(i, planned);
      stamp(packets_[i % kPackets], i);
      notice_pause();
      sender_.send(packets_[i % kPackets]);
      if (i % 76 == 0 && !wait_for_scans(i)) return false;
      if (share(kSamples, i, planned) != share(kSamples, i + 1, planned)) {
        take_sample(process.id(), i + 1);
      }
    }
    if (total_ != planned) take_sample(process.id(), total_);
    result_ = process.wait();
    return judge();
  }
  void write(const std::filesystem::path& file) const;

 private:
  [[nodiscard]] static std::size_t share(std::size_t of, std::size_t i, std::size_t total) {
    return static_cast<std::size_t>(static_cast<double>(of) * static_cast<double>(i) /
                                    static_cast<double>(total));
  }
  void disturb(std::size_t i, std::size_t planned) {
    if (share(kReconnects, i, planned) != share(kReconnects, i + 1, planned)) {
      sender_.reconnect();
      ++reconnects_;
    }
    for (std::size_t n = share(kMalformed, i, planned); n < share(kMalformed, i + 1, planned);
         ++n) {
      sender_.send(malformed_[random_() % malformed_.size()]);
      ++sent_malformed_;
    }
  }
  void notice_pause() {
    const auto now = std::chrono::steady_clock::now();
    if (now - last_sent_ > kPause) ++pauses_;
    last_sent_ = now;
  }
  /// So that few wait: two seconds between two packets, while those before them are used, would be
  /// the sensor's clock set back.
  [[nodiscard]] bool wait_for_scans(std::size_t packets) {
    const auto sent =
        static_cast<std::size_t>(static_cast<double>(packets) / kPacketsPerRevolution);
    for (int i = 0; i < 60'000; ++i) {
      if (log_.lines() + 20 >= sent) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    std::cout << "no scan for a minute\n";
    return false;
  }
  void take_sample(pid_t process, std::size_t packets) {
    samples_.push_back({static_cast<double>(packets) * kPacketUs / 3.6e9, log_.lines() - 1,
                        sender_.sent(), resident_kb(process), pauses_});
    const Sample& last = samples_.back();
    std::printf("%.3f h: %zu scans, %zu kB, %zu pauses\n", last.hours, last.scans, last.memory_kb,
                last.pauses);
    std::fflush(stdout);
  }
  bool expect(bool good, const std::string& what) {
    if (!good) std::cout << "NOT: " << what << '\n';
    return good;
  }
  /// Since the first quarter was over: by how much memory grew [B], and over how many scans. But
  /// for the samples of a pause: more scans wait after one than ever before, and memory that was
  /// used once is kept.
  [[nodiscard]] std::pair<double, double> growth() const {
    double grown = 0.0, scans = 0.0;
    for (std::size_t i = samples_.size() / 4 + 1; i < samples_.size(); ++i) {
      const Sample& last = samples_[i - 1];
      if (samples_[i].pauses != last.pauses) continue;
      grown += 1024.0 *
               (static_cast<double>(samples_[i].memory_kb) - static_cast<double>(last.memory_kb));
      scans += static_cast<double>(samples_[i].scans - last.scans);
    }
    return {grown, scans};
  }
  bool judge();

  std::size_t total_;  ///< packets of the sensor
  std::string silence_;
  std::mt19937 random_;
  std::vector<std::string> packets_;
  std::vector<std::string> malformed_;
  ScratchFolder scratch_;
  PatientSender sender_;
  Follower log_{scratch_.path() / "live" / "live.log"};
  std::size_t reconnects_ = 0, sent_malformed_ = 0, pauses_ = 0;
  std::chrono::steady_clock::time_point last_sent_ = std::chrono::steady_clock::now();
  std::vector<Sample> samples_;
  ProcessResult result_;
};

bool Soak::judge() {
  std::cout << result_.output << result_.errors;
  const std::size_t lines = lines_of(scratch_.path() / "live" / "trajectory_kitti.txt");
  const std::size_t measured = lines_of(scratch_.path() / "live" / "trajectory.tum") - 1;
  const auto scans = static_cast<std::size_t>(static_cast<double>(total_) / kPacketsPerRevolution);
  const auto [grown, over] = growth();
  std::printf(
      "%.2f h; %zu datagrams, %zu of them malformed, %zu reconnects; %zu poses, %zu measured, "
      "%zu pauses; "
      "memory grew by %.0f kB after the first quarter, %.2f B a scan\n",
      static_cast<double>(total_) * kPacketUs / 3.6e9, sender_.sent(), sent_malformed_, reconnects_,
      lines, measured, pauses_, grown / 1024.0, grown / std::max(over, 1.0));
  bool good = expect(result_.exit_code == 0, "exit code 0");
  const auto has = [&](const std::string& text) {
    return result_.output.find(text) != std::string::npos;
  };
  good &= expect(has(" 0 dropped"), "no scan dropped");
  good &= expect(has(", 0 by a full socket"), "no datagram lost");
  good &= expect(has(std::to_string(sender_.sent()) + " datagrams, " + std::to_string(total_) +
                     " of them data"),
                 "all datagrams received, and told apart");
  good &= expect(lines + 2 >= scans && lines <= scans + 1 + pauses_, "a pose for each revolution");
  good &= expect(measured + 2 * pauses_ >= lines, "each of them measured");
  good &= expect(grown < kMostBytes, "memory is flat");
  return good;
}

void Soak::write(const std::filesystem::path& file) const {
  std::ofstream out(file);
  out << "simulated_h,scans,datagrams,memory_kb,pauses\n";
  for (const Sample& one : samples_) {
    out << one.hours << ',' << one.scans << ',' << one.datagrams << ',' << one.memory_kb << ','
        << one.pauses << '\n';
  }
}

}  // namespace
}  // namespace surefoot::test

int main(int count, char** arguments) {
  std::signal(SIGINT, [](int) { surefoot::test::is_stopped = 1; });
  const double hours = count > 1 ? std::atof(arguments[1]) : 0.1;
  const int one_return_of = count > 2 ? std::atoi(arguments[2]) : 8;
  if (!(hours > 0.0) || one_return_of < 1) {
    std::cerr << "usage: live_soak [HOURS] [ONE_RETURN_OF] [FILE.csv]\n";
    return 2;
  }
  surefoot::test::Soak soak(hours, static_cast<std::size_t>(one_return_of));
  const bool good = soak.run();
  if (count > 3) soak.write(arguments[3]);
  return good ? 0 : 1;
}
