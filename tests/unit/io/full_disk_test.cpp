// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "io/bags/bag_writer.hpp"
#include "io/file_writer.hpp"
#include "io/packets/datagram_writer.hpp"
#include "unit/io/support.hpp"

namespace surefoot::io {
namespace {

// Linux's file that is on a disk without any room.
constexpr const char* kFull = "/dev/full";
constexpr const char* kWhy = "/dev/full: cannot be written: No space left on device";

TEST(FullDisk, IsWhatABagSaysThatCannotBeWritten) {
  for (const auto make : {make_ros1_bag, make_mcap_bag}) {
    for (const std::size_t size : {std::size_t{10}, std::size_t{8} << 20}) {
      EXPECT_EQ(test::message_of<WriteError>([&] {
                  const auto bag = make(kFull);
                  const std::size_t topic = bag->add_topic("/points", point_cloud2_definition());
                  bag->write(topic, 1'500'000'000, std::string(size, 'x'));
                  bag->finish();
                }),
                kWhy);
    }
  }
}

TEST(FullDisk, IsWhatARecordOfDatagramsSaysThatCannotBeWritten) {
  EXPECT_EQ(test::message_of<WriteError>([] { DatagramWriter writer(kFull); }), kWhy);
  EXPECT_EQ(test::message_of<WriteError>([] { DatagramWriter writer("/none/a.pcap"); }),
            "/none/a.pcap: cannot be written: No such file or directory");
}

}  // namespace
}  // namespace surefoot::io
