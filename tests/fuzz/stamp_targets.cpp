// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Stamps, receipts and point clocks of any kind, mended as those of a recording are.
#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>

#include "fuzz/targets.hpp"
#include "fuzz/whole_way.hpp"
#include "io/point_time_watch.hpp"
#include "io/saturated.hpp"
#include "io/stamp_repair.hpp"
#include "unit/io/support.hpp"

namespace surefoot::fuzz {
namespace {

/// What of a scan the bytes tell: steps from the one before.
struct Step {
  std::int32_t stamp = 0;    ///< [ns * `scale`]
  std::int32_t clock = 0;    ///< likewise
  std::int16_t late_ms = 0;  ///< received after its stamp
  std::uint8_t scale = 0;    ///< powers of ten
  std::uint8_t kind = 0;     ///< bits: no scan, no receipt, no clock, no times, the same points
  std::int8_t lasts_ms = 0;  ///< of the sweep
};
constexpr std::size_t kStepBytes = 13;
enum Kind { no_scan = 1, no_receipt = 2, no_clock = 4, no_times = 8, same_points = 16 };

Step step_of(Bytes bytes) {
  Step step;
  const auto* const begin = bytes.data();
  std::memcpy(&step.stamp, begin, 4);
  std::memcpy(&step.clock, begin + 4, 4);
  std::memcpy(&step.late_ms, begin + 8, 2);
  std::memcpy(&step.scale, begin + 10, 1);
  std::memcpy(&step.kind, begin + 11, 1);
  std::memcpy(&step.lasts_ms, begin + 12, 1);
  return step;
}

class SteppedRecording final : public io::Recording {
 public:
  explicit SteppedRecording(Bytes bytes) : bytes_(bytes) {}

  std::optional<io::ScanItem> next() override {
    if (bytes_.size() < kStepBytes) return std::nullopt;
    const Step step = step_of(bytes_);
    bytes_ = bytes_.subspan(kStepBytes);
    std::int64_t scale = 1;
    for (int i = 0; i < step.scale % 12; ++i) scale *= 10;
    stamp_ns_ = io::sane_time(io::sum(stamp_ns_, io::times(step.stamp, scale)));
    clock_ns_ = io::sane_time(io::sum(clock_ns_, io::times(step.clock, scale)));
    io::ScanItem item;
    item.name = "scan";
    if ((step.kind & no_receipt) == 0) {
      item.logged_ns = io::sum(stamp_ns_, step.late_ms * std::int64_t{1'000'000});
    }
    if ((step.kind & no_scan) != 0) {
      item.error = "none";
      return item;
    }
    item.scan = scan_of(step);
    if ((step.kind & no_clock) == 0) item.clock = io::PointClock{clock_ns_, clock_ns_};
    return item;
  }
  std::optional<std::size_t> size() const override { return std::nullopt; }
  void skip(std::size_t scans) override {
    while (scans-- > 0 && next()) {
    }
  }
  double progress() const override { return 0.0; }
  const std::vector<std::string>& notes() const override { return notes_; }
  std::string description() const override { return "steps"; }

 private:
  Scan scan_of(const Step& step) {
    Scan scan = small_scan();
    scan.stamp_ns = stamp_ns_;
    if ((step.kind & same_points) == 0) turn_ += 1.0F;
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
      scan.points[i].z() += turn_;
      scan.times_ns[i] = static_cast<std::int32_t>(i) * step.lasts_ms * 250'000;
    }
    if ((step.kind & no_times) != 0) scan.times_ns.clear();
    return scan;
  }

  Bytes bytes_;
  std::int64_t stamp_ns_ = 0, clock_ns_ = 0;
  float turn_ = 0.0F;
  std::vector<std::string> notes_;
};

// The first byte chooses how; stamps that were mended have to grow.
void read_stamps(Bytes bytes) {
  if (bytes.empty()) return;
  const auto choice = std::to_integer<unsigned>(bytes.front());
  io::OpenOptions options;
  options.repair_at_once = choice % 2 == 1;
  options.rate_hz = choice / 2 % 2 == 1 ? 10.0 : 0.0;
  const auto recording = io::repair_stamps(
      io::watch_point_times(std::make_unique<SteppedRecording>(bytes.subspan(1)), options),
      options);
  std::optional<std::int64_t> last_ns;
  if (choice / 4 % 2 == 1) recording->skip(choice / 8);
  while (const std::optional<io::ScanItem> item = recording->next()) {
    if (!item->scan) continue;
    const std::int64_t stamp_ns = item->scan->stamp_ns;
    const bool grows = !last_ns || stamp_ns > *last_ns;
    if (!grows && stamp_ns < std::numeric_limits<std::int64_t>::max()) std::abort();
    last_ns = stamp_ns;
  }
}

std::string stepping(const std::vector<Step>& steps) {
  using io::test::little;
  std::string bytes(1, '\0');
  for (const Step& step : steps) {
    bytes += little(step.stamp) + little(step.clock) + little(step.late_ms) + little(step.scale) +
             little(step.kind) + little(step.lasts_ms);
  }
  return bytes;
}

Seeds stamp_seeds() {
  const Step usual{1000, 1000, 20, 5, 0, 100};
  std::vector<Step> steady(12, usual), jumping = steady, standing = steady, arriving(40, usual);
  jumping[5].stamp = -100'000;
  jumping[8].stamp = 2'000'000;
  for (std::size_t i = 4; i < 12; ++i) standing[i].stamp = 0;
  for (std::size_t i = 0; i < arriving.size(); ++i) {
    arriving[i].kind = no_clock;
    arriving[i].stamp += i % 2 == 0 ? 400 : -400;
  }
  return {stepping(steady), stepping(jumping), stepping(standing), stepping(arriving)};
}

constexpr Target kStampTargets[] = {{"stamps", read_stamps, stamp_seeds}};

}  // namespace

std::span<const Target> stamp_targets() { return kStampTargets; }

}  // namespace surefoot::fuzz
