// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// How fast recordings are read, from the page cache, by one thread: reading_rate RECORDING...
//
// Every recording is read twice, the second time counts. With --generate FILE it first writes a bag
// of --gigabytes (one dense scan over and over) and tells how memory stands while reading it.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <ctime>
#include <filesystem>

#include "io/bags/bag_writer.hpp"
#include "io/messages/message_definitions.hpp"
#include "io/messages/point_cloud2_writer.hpp"
#include "io/recording.hpp"
#include "memory.hpp"
#include "surefoot/seconds.hpp"

namespace {

namespace fs = std::filesystem;
using namespace surefoot;

double bytes_of(const fs::path& path) {
  if (!fs::is_directory(path)) return static_cast<double>(fs::file_size(path));
  double sum = 0.0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(path)) {
    if (entry.is_regular_file()) sum += static_cast<double>(entry.file_size());
  }
  return sum;
}

struct Reading {
  double seconds = 0.0;   // of this process's CPU
  double duration = 0.0;  // of the recording, by its stamps [s]
  std::size_t scans = 0;
  double points = 0.0;
  double least_memory = INFINITY, most_memory = 0.0;  // [MB] after the first 100 scans
};

Reading read(const fs::path& path) {
  Reading result;
  const std::clock_t begin = std::clock();
  const auto recording = io::open_recording(path, {});
  std::int64_t first = 0, last = 0;
  while (const auto item = recording->next()) {
    if (!item->scan) continue;
    if (result.scans++ == 0) first = item->scan->stamp_ns;
    last = item->scan->stamp_ns;
    result.points += static_cast<double>(item->scan->points.size());
    if (result.scans > 100 && result.scans % 100 == 0) {
      const double memory = benchmarks::resident_megabytes();
      result.least_memory = std::min(result.least_memory, memory);
      result.most_memory = std::max(result.most_memory, memory);
    }
  }
  result.seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  result.duration = seconds(last - first);
  return result;
}

/// 131,072 points of a slow wave, each scan moved on, so that no two are alike.
Scan dense_scan() {
  Scan scan;
  for (int i = 0; i < 128 * 1024; ++i) {
    const float angle = 6.2832F * static_cast<float>(i / 128) / 1024.0F;
    const float range = 10.0F + static_cast<float>(i % 128) * 0.05F;
    scan.points.emplace_back(range * std::cos(angle), range * std::sin(angle), 0.1F);
    scan.intensities.push_back(static_cast<float>(i % 256));
    scan.times_ns.push_back(i / 128 * 97'656);
    scan.rings.push_back(static_cast<std::uint16_t>(i % 128));
  }
  return scan;
}

void generate(const fs::path& file, double gigabytes) {
  const auto bag = file.extension() == ".bag" ? io::make_ros1_bag(file) : io::make_mcap_bag(file);
  const std::size_t topic = bag->add_topic("/points", io::point_cloud2_definition());
  Scan scan = dense_scan();
  double written = 0.0;
  for (std::int64_t i = 0; written < 1e9 * gigabytes; ++i) {
    scan.stamp_ns = 1'700'000'000'000'000'000 + i * 100'000'000;
    scan.points[0].x() = static_cast<float>(i);
    const std::string message = io::format_point_cloud2(scan, "lidar", bag->flavour());
    bag->write(topic, scan.stamp_ns, message);
    written += static_cast<double>(message.size());
  }
  bag->finish();
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"How fast recordings are read"};
  std::vector<fs::path> recordings;
  fs::path generated;
  double gigabytes = 20.0;
  app.add_option("recordings", recordings);
  app.add_option("--generate", generated,
                 "write this bag (.bag: not compressed; .mcap: Zstandard), and read it once");
  app.add_option("--gigabytes", gigabytes)->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  fmt::print("recording,megabytes,scans,points,cpu [s],GB/s,times real time,memory [MB]\n");
  const auto print = [](const fs::path& path, const Reading& reading) {
    const double megabytes = 1e-6 * bytes_of(path);
    const bool steady = reading.most_memory > 0.0;
    fmt::print("{},{:.0f},{},{:.0f},{:.3f},{:.2f},{:.0f},{}\n", path.filename().string(), megabytes,
               reading.scans, reading.points, reading.seconds, 1e-3 * megabytes / reading.seconds,
               reading.duration / reading.seconds,
               steady ? fmt::format("{:.0f} to {:.0f}", reading.least_memory, reading.most_memory)
                      : std::string());
  };
  if (!generated.empty()) {
    generate(generated, gigabytes);
    print(generated, read(generated));
  }
  for (const fs::path& path : recordings) {
    (void)read(path);
    print(path, read(path));
  }
  return 0;
}
