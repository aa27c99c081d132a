// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <libdeflate.h>
#include <sys/stat.h>

#include <limits>

#include "io/bags/compression.hpp"
#include "io/packets/metadata_file.hpp"
#include "io/recording.hpp"
#include "unit/io/support.hpp"

namespace surefoot::io {
namespace {

constexpr std::int64_t kCaptureStart = 1'453'363'200'000'000'000;  // a whole hour
constexpr std::int64_t kPacketPeriod = 1'327'104;

std::string payload(unsigned i, unsigned product = 0x22) {
  return test::vlp16_payload(
      i * 480 % 36000, 40, static_cast<std::uint32_t>(i * kPacketPeriod / 1000), 0x37,
      [](auto, auto) {
        return test::Measured{500, 1};
      },
      product);
}

// Two turns of 75 packets.
test::PcapFile two_turns(bool nanoseconds, bool big_endian) {
  test::PcapFile file(1, nanoseconds, big_endian);
  for (unsigned i = 0; i < 150; ++i) {
    file.add(kCaptureStart + i * kPacketPeriod,
             test::ethernet_frame(test::ip_packet(payload(i), 2368)));
  }
  return file;
}

TEST(Capture, EveryMagicGivesTheSame) {
  const test::TemporaryFolder folder;
  for (const bool nanoseconds : {false, true}) {
    for (const bool big_endian : {false, true}) {
      const auto recording =
          open_recording(folder.write("a.pcap", two_turns(nanoseconds, big_endian).content()));
      const auto first = recording->next();
      const auto second = recording->next();
      ASSERT_TRUE(first && second);
      EXPECT_FALSE(recording->next());
      EXPECT_EQ(first->scan->stamp_ns, kCaptureStart);
      EXPECT_EQ(first->scan->points.size(), 75U * 384U);
      EXPECT_EQ(first->remark, "");
      EXPECT_EQ(second->scan->stamp_ns, kCaptureStart + 75 * kPacketPeriod / 1000 * 1000);
      EXPECT_EQ(recording->capture_counts().lost, 0U);
      EXPECT_EQ(recording->progress(), 1.0);
    }
  }
}

// What is asked for is done; that the packets say otherwise is told.
TEST(Capture, ASensorThatThePacketsContradictIsTold) {
  const test::TemporaryFolder folder;
  const auto notes_of = [&](const std::string& sensor) {
    OpenOptions options;
    options.sensor = sensor;
    const auto recording =
        open_recording(folder.write("a.pcap", two_turns(false, false).content()), options);
    EXPECT_TRUE(recording->next());
    return test::joined(recording->notes());
  };
  const std::string told = notes_of("vlp-32c");
  EXPECT_NE(told.find("the packets name a VLP-16; they are read as a VLP-32C's"), std::string::npos)
      << told;
  for (const char* right : {"", "vlp16"}) {
    EXPECT_EQ(notes_of(right).find("name a"), std::string::npos) << right;
  }
}

TEST(Capture, PcapngGivesTheSame) {
  const test::TemporaryFolder folder;
  for (const unsigned decimals : {6U, 9U}) {
    for (const bool big_endian : {false, true}) {
      test::PcapngFile file(1, decimals, big_endian);
      for (unsigned i = 0; i < 150; ++i) {
        file.add(kCaptureStart + i * kPacketPeriod,
                 test::ethernet_frame(test::ip_packet(payload(i), 2368)));
      }
      const auto recording = open_recording(folder.write("a.pcapng", file.content()));
      const auto first = recording->next();
      const auto second = recording->next();
      ASSERT_TRUE(first && second);
      EXPECT_FALSE(recording->next());
      EXPECT_EQ(first->scan->stamp_ns, kCaptureStart);
      EXPECT_EQ(first->scan->points.size(), 75U * 384U);
      EXPECT_EQ(second->scan->stamp_ns, kCaptureStart + 75 * kPacketPeriod / 1000 * 1000);
      EXPECT_EQ(recording->capture_counts().data_packets, 150U);
    }
  }
}

// Without GPS the capture's own stamp gives the start, to the last digit it has.
TEST(Capture, StampsAreReadToTheirResolution) {
  const test::TemporaryFolder folder;
  constexpr std::int64_t kOdd =
      kCaptureStart + 1'800'000'000'000 + 123'456'789;  // half past the hour
  const std::string frame = test::ethernet_frame(test::ip_packet(payload(0), 2368));
  const auto stamp_of = [&](auto file) {
    file.add(kOdd, frame);
    return open_recording(folder.write("a.pcap", file.content()))->next()->scan->stamp_ns;
  };
  EXPECT_EQ(stamp_of(test::PcapngFile(1, 9)), kOdd);
  EXPECT_EQ(stamp_of(test::PcapngFile(1, 6)), kOdd - 789);
  EXPECT_EQ(stamp_of(test::PcapngFile(1, 3)), kOdd - 456'789);
  EXPECT_EQ(stamp_of(test::PcapFile(1, true)), kOdd);
  EXPECT_EQ(stamp_of(test::PcapFile(1, false)), kOdd - 789);
}

struct Link {
  const char* name;
  std::uint16_t type;  ///< of the capture formats' list, LINKTYPE_...
  std::string header;  ///< before the IP packet
};

// As `tcpdump -i any`, a loopback interface and a tunnel write them.
TEST(Capture, EveryLinkLayerGivesTheSame) {
  const std::string ipv4("\x08\x00", 2);
  const Link links[] = {
      {"Linux cooked", 113, std::string("\0\0\0\x01\0\x06\x60\x76\x88\0\0\0\0\0", 14) + ipv4},
      {"Linux cooked 2", 276, ipv4 + std::string(18, '\0')},
      {"loopback, little-endian", 0, std::string("\x02\0\0\0", 4)},
      {"loopback, big-endian", 108, std::string("\0\0\0\x02", 4)},
      {"raw IP", 101, ""},
      {"raw IPv4", 228, ""},
  };
  const test::TemporaryFolder folder;
  for (const Link& link : links) {
    SCOPED_TRACE(link.name);
    test::PcapFile classic(link.type);
    test::PcapngFile next_generation(link.type);
    for (unsigned i = 0; i < 75; ++i) {
      const std::string frame = link.header + test::ip_packet(payload(i), 2368);
      classic.add(kCaptureStart + i * kPacketPeriod, frame);
      next_generation.add(kCaptureStart + i * kPacketPeriod, frame);
    }
    for (const std::string& content : {classic.content(), next_generation.content()}) {
      const auto recording = open_recording(folder.write("a.pcap", content));
      const auto item = recording->next();
      ASSERT_TRUE(item);
      EXPECT_EQ(item->scan->stamp_ns, kCaptureStart);
      EXPECT_EQ(item->scan->points.size(), 75U * 384U);
      EXPECT_EQ(recording->capture_counts().other, 0U);
    }
  }
}

TEST(Capture, OtherTrafficIsCountedAndSkipped) {
  const test::TemporaryFolder folder;
  test::PcapFile file;
  for (unsigned i = 0; i < 75; ++i) {
    const std::string frame = test::ethernet_frame(test::ip_packet(payload(i), 2368));
    if (i != 40) {
      file.add(kCaptureStart + i * kPacketPeriod, frame,
               i == 50 ? 100 : 0);  // one lost, one cut short
    }
  }
  file.add(kCaptureStart, test::ethernet_frame(test::ip_packet(std::string(512, 'p'), 8308)));
  file.add(kCaptureStart, test::ethernet_frame(test::ip_packet(payload(1), 9999)));
  file.add(kCaptureStart, "arp");
  const auto recording = open_recording(folder.write("a.pcap", file.content()));
  const auto item = recording->next();
  EXPECT_NE(item->remark.find("partial"), std::string::npos);
  EXPECT_FALSE(recording->next());
  const CaptureCounts counts = recording->capture_counts();
  EXPECT_EQ(counts.data_packets, 73U);
  EXPECT_EQ(counts.position_packets, 1U);
  EXPECT_EQ(counts.truncated, 1U);
  EXPECT_EQ(counts.other, 2U);
  EXPECT_EQ(counts.lost, 2U);
}

TEST(Capture, ACaptureThatIsCutShortGivesWhatItHas) {
  const test::TemporaryFolder folder;
  const std::string content = two_turns(false, false).content();
  const auto recording =
      open_recording(folder.write("a.pcap", content.substr(0, content.size() - 5)));
  std::size_t scans = 0;
  while (recording->next()) {
    ++scans;
  }
  EXPECT_EQ(scans, 2U);
  EXPECT_NE(recording->notes().back().find("cut short"), std::string::npos);
}

// Seconds that do not fit into 64 bits of nanoseconds; pcapng can say them, by its resolution.
TEST(Capture, AClockThatIsSetAtEveryPacketIsNotNotedWithoutEnd) {
  const test::TemporaryFolder folder;
  test::PcapFile file;
  for (unsigned i = 0; i < 150; ++i) {
    const std::string packet =
        test::vlp16_payload(i * 480, 40, i % 2 * 600'000'000U + i * 1327, 0x37, [](auto, auto) {
          return test::Measured{500, 1};
        });
    file.add(kCaptureStart + i * kPacketPeriod,
             test::ethernet_frame(test::ip_packet(packet, 2368)));
  }
  const auto recording = open_recording(folder.write("a.pcap", file.content()));
  while (recording->next()) {
  }
  EXPECT_GT(recording->notes().size(), 5U);
  EXPECT_LT(recording->notes().size(), 20U);
}

TEST(Capture, AStampBeyondAllTimesEndsTheCapture) {
  const test::TemporaryFolder folder;
  const std::string frame = test::ethernet_frame(test::ip_packet(payload(75), 2368));
  const std::int64_t ticks = std::numeric_limits<std::int64_t>::max();
  test::PcapngFile file(1, 9);  // the header's digit says that stamps are nanoseconds
  for (unsigned i = 0; i < 75; ++i) {
    file.add(kCaptureStart + i * kPacketPeriod,
             test::ethernet_frame(test::ip_packet(payload(i), 2368)));
  }
  file.add(ticks, frame);  // the year 2262: whole nanoseconds, but no difference to 1970 minus it
  const auto recording = open_recording(folder.write("late.pcapng", file.content()));
  ASSERT_TRUE(recording->next());
  EXPECT_FALSE(recording->next());
  EXPECT_NE(recording->notes().back().find("stamped 9223372036 s"), std::string::npos)
      << recording->notes().back();

  test::PcapngFile seconds(1, 0);  // 2^63 - 1 seconds
  seconds.add_ticks(static_cast<std::uint64_t>(ticks), frame);
  const auto late = folder.write("seconds.pcapng", seconds.content());
  const std::string message = test::message_of<ReadError>([&] { (void)open_recording(late); });
  EXPECT_NE(message.find("stamped 9223372036854775807 s"), std::string::npos) << message;
}

TEST(Capture, ErrorsNameWhatWasSeen) {
  const test::TemporaryFolder folder;
  const auto error_of = [&](const std::string& content) {
    const auto file = folder.write("a.pcap", content);
    return test::message_of<ReadError>([&] { (void)open_recording(file); });
  };
  EXPECT_NE(error_of("").find("a.pcap: no pcap"), std::string::npos);
  EXPECT_NE(error_of("not a capture at all").find("no pcap"), std::string::npos);
  EXPECT_NE(error_of(test::PcapFile().content()).find("0 packets"), std::string::npos);
  EXPECT_NE(error_of(test::PcapFile(105).content()).find("link layer 105"), std::string::npos);
  test::PcapFile velarray;
  velarray.add(kCaptureStart, test::ethernet_frame(test::ip_packet(payload(0, 0x31), 2368)));
  const std::string product = error_of(velarray.content());
  EXPECT_NE(product.find("0x31 (Velarray)"), std::string::npos) << product;
  test::PcapFile elsewhere;
  elsewhere.add(kCaptureStart, test::ethernet_frame(test::ip_packet(payload(0), 2369)));
  const auto file = folder.write("a.pcap", elsewhere.content());
  OpenOptions options;
  options.udp_port = 2368;
  const auto with = [&] { (void)open_recording(file, options); };
  EXPECT_NE(test::message_of<ReadError>(with).find("1206 bytes to port 2369"), std::string::npos);
  options = {};
  with();
  options.sensor = "no such thing";
  EXPECT_NE(test::message_of<ReadError>(with).find("VLP-32C"), std::string::npos);
  options.sensor = "vlp16";
  options.calibration_file = folder.path() / "absent.yaml";
  EXPECT_NE(test::message_of<ReadError>(with).find("absent.yaml"), std::string::npos);
}

std::string gzip(std::string_view bytes) {
  libdeflate_compressor* const compressor = libdeflate_alloc_compressor(1);
  std::string packed(libdeflate_gzip_compress_bound(compressor, bytes.size()), '\0');
  packed.resize(libdeflate_gzip_compress(compressor, bytes.data(), bytes.size(), packed.data(),
                                         packed.size()));
  libdeflate_free_compressor(compressor);
  return packed;
}

std::size_t scans_in(Recording& recording) {
  std::size_t scans = 0;
  while (recording.next()) ++scans;
  return scans;
}

// By its content, whatever it is called; gzip puts members one behind the other.
TEST(Capture, CompressedAsAWhole) {
  const test::TemporaryFolder folder;
  const std::string plain = two_turns(true, false).content();
  const std::string two = gzip(plain.substr(0, 70'001)) + gzip(plain.substr(70'001));
  const std::pair<const char*, std::string> files[] = {
      {"a.pcap.gz", gzip(plain)},
      {"a.pcap", two},
      {"b.pcap.zst", compress(Compression::zstd, plain)},
      {"walk", compress(Compression::lz4, plain)}};
  for (const auto& [name, bytes] : files) {
    const auto recording = open_recording(folder.write(name, bytes));
    EXPECT_EQ(scans_in(*recording), 2U) << name;
    EXPECT_EQ(recording->progress(), 1.0);
    EXPECT_TRUE(recording->losses().empty()) << recording->losses().front();
  }
}

TEST(Capture, DamagedInCompressionIsReadAsFarAsItGoes) {
  const test::TemporaryFolder folder;
  const std::string one = gzip(two_turns(true, false).content());
  std::string damaged = one + one;
  damaged.replace(one.size(), 12, 12, '\x7f');
  const auto recording = open_recording(folder.write("a.pcap.gz", damaged));
  EXPECT_EQ(scans_in(*recording), 2U);
  ASSERT_EQ(recording->losses().size(), 1U);
  EXPECT_NE(recording->losses().front().find("gzip: the data are damaged"), std::string::npos);
  const auto other = folder.write("b.pcap", "\x1f\x8b\x08 this is not what gzip writes");
  EXPECT_NE(test::message_of<ReadError>([&] { (void)open_recording(other); }).find("gzip"),
            std::string::npos);
}

// Opening a pipe would wait for a writer.
TEST(Capture, ANamedPipeIsRefused) {
  const test::TemporaryFolder folder;
  const auto pipe = folder.path() / "a.pcap";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const std::string message = test::message_of<ReadError>([&] { (void)open_recording(pipe); });
  EXPECT_NE(message.find("a.pcap: it is a named pipe"), std::string::npos) << message;
}

// Two sensors at one port are told apart by their addresses: the first one's packets are taken.
TEST(Capture, ASecondSensorIsLeftOut) {
  const test::TemporaryFolder folder;
  test::PcapFile file;
  for (unsigned i = 0; i < 75; ++i) {
    std::string ip = test::ip_packet(payload(i), 2368);
    file.add(kCaptureStart + i * kPacketPeriod, test::ethernet_frame(ip));
    ip[15] = '\x02';  // of the source address
    file.add(kCaptureStart + i * kPacketPeriod + 1000, test::ethernet_frame(ip));
  }
  const auto recording = open_recording(folder.write("a.pcap", file.content()));
  const auto item = recording->next();
  EXPECT_EQ(item->scan->points.size(), 75U * 384U);
  EXPECT_FALSE(recording->next());
  EXPECT_EQ(recording->capture_counts().data_packets, 75U);
  EXPECT_EQ(recording->capture_counts().other, 75U);
  const std::string notes = test::joined(recording->notes());
  const std::size_t told = notes.find("another VLP-16 at ");
  ASSERT_NE(told, std::string::npos) << notes;
  EXPECT_NE(notes.find(".2:2368, not read"), std::string::npos) << notes;
  EXPECT_EQ(notes.find("another", told + 1), std::string::npos) << "once: " << notes;
}

TEST(Capture, MetadataAreFoundByANameThatIsAlike) {
  const test::TemporaryFolder folder;
  const std::filesystem::path capture = folder.path() / "walk_lb.pcap";
  const auto write = [&](const char* name, const char* who) {
    folder.write(name, std::string("{\"beam_altitude_angles\": [], \"of\": \"") + who + "\"}");
  };
  const auto found = [&] { return metadata_beside(capture); };
  write("other.json", "other");
  folder.write("walk_lb_digest.json", "{}");
  EXPECT_EQ(found().text, "");
  EXPECT_EQ(found().remark, "");
  write("walk_lb_0.json", "first");
  EXPECT_NE(found().text.find("first"), std::string::npos);
  EXPECT_NE(found().remark.find("walk_lb_0.json"), std::string::npos);
  write("walk_lb_1.json", "second");
  EXPECT_EQ(found().text, "");
  EXPECT_NE(found().remark.find("walk_lb_0.json, walk_lb_1.json"), std::string::npos);
  write("walk.json", "beginning");
  EXPECT_NE(found().text.find("beginning"), std::string::npos);
  write("wal.json", "shorter");
  EXPECT_NE(found().text.find("beginning"), std::string::npos);
  write("walk_lb.json", "exact");
  EXPECT_NE(found().text.find("exact"), std::string::npos);
  EXPECT_EQ(found().remark, "");
}

}  // namespace
}  // namespace surefoot::io
