// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// How fast rosbag_storage, ROS 1's own library, reads a bag's clouds: rosbag_storage_rate BAG
// [points]. It reads it twice, the second time counts; it prints "messages,points,cpu [s]". The
// messages are made, their points' bytes copied; with "points" x, y, z of each are read, too, by
// sensor_msgs' iterators. benchmarks/compare_readers runs it.
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sensor_msgs/PointCloud2.h>
#include <sensor_msgs/point_cloud2_iterator.h>

#include <cstdio>
#include <ctime>

namespace {

float sum_of_points(const sensor_msgs::PointCloud2& cloud) {
  float sum = 0.0F;
  sensor_msgs::PointCloud2ConstIterator<float> at(cloud, "x");
  for (; at != at.end(); ++at) sum += at[0] + at[1] + at[2];
  return sum;
}

void read(const char* file, bool with_points, bool counts) {
  volatile float sum = 0.0F;
  const std::clock_t begin = std::clock();
  rosbag::Bag bag(file);
  rosbag::View view(bag);
  std::size_t messages = 0, points = 0;
  for (const rosbag::MessageInstance& message : view) {
    const sensor_msgs::PointCloud2::ConstPtr cloud =
        message.instantiate<sensor_msgs::PointCloud2>();
    if (cloud == nullptr) continue;
    ++messages;
    points += std::size_t{cloud->width} * cloud->height;
    if (with_points) sum = sum + sum_of_points(*cloud);
  }
  const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  if (counts) std::printf("%zu,%zu,%.4f\n", messages, points, seconds);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: rosbag_storage_rate BAG [points]\n");
    return 2;
  }
  try {
    read(argv[1], argc > 2, false);
    read(argv[1], argc > 2, true);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
  return 0;
}
