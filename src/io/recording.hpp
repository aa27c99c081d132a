// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A recording is a sequence of scans, whatever it is stored in. Open one with open_recording().
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/scan_fields.hpp"
#include "sensors/packet_decoder.hpp"
#include "surefoot/scan.hpp"

namespace surefoot::io {

/// What was read is not what it should be. The message names the file, what was seen and what was
/// expected.
class ReadError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

enum class TimeUnit { automatic, seconds, milliseconds, microseconds, nanoseconds };
/// What the values of a time field count from.
enum class TimeReference {
  automatic,
  relative,  ///< the scan's stamp
  absolute,  ///< the epoch of the stamps
  own_clock  ///< something else, as the LiDAR's start: a scan's first point is at its stamp
};
/// Which instant of a scan its stamp names, where relative point times are all positive. automatic:
/// what the data set says, else the start.
enum class StampAt { automatic, start, end };
/// Whether point times are made up where the recording has none.
enum class DeriveTimes {
  no,
  azimuth,  ///< by where a point lies within a revolution
};
/// Which way point times count, and whether they count at all.
enum class TimeDirection {
  forward,
  backward,  ///< back from the stamp, where a field holds how old a point is
  none       ///< left out: the scans are deskewed already
};
/// How a LiDAR turns, seen from above.
enum class Spin { clockwise, counterclockwise };
using sensors::ReturnChoice;

/// How to read. The defaults find everything out from the recording itself.
struct OpenOptions {
  /// One of dataset_names() (datasets.hpp): it says what else here is left open; empty: none.
  std::string dataset;
  /// One of robot_names() (robots.hpp): likewise, of what its own software publishes.
  std::string robot;
  /// "pcd", "ply" or "bin" for a folder that holds several kinds; empty: the one kind there is.
  std::string format;
  /// Topic of a bag; empty: the only one that scans can be made of.
  std::string topic;
  /// Where no topic is asked for: the first of these that the bag has.
  std::vector<std::string> likely_topics;
  /// Name of the field of point times; empty: the first of the names that drivers use.
  std::string time_field;
  TimeUnit time_unit = TimeUnit::automatic;
  TimeReference time_reference = TimeReference::automatic;
  StampAt stamp_at = StampAt::automatic;
  /// Scans of so many points, stored column by column as the LiDAR turned, get their times from
  /// that; 0: none do.
  std::size_t rows = 0;
  std::size_t columns = 0;
  TimeDirection time_direction = TimeDirection::forward;
  DeriveTimes derive_times = DeriveTimes::no;
  Spin spin = Spin::clockwise;  ///< of derived times
  /// Mend stamps that cannot be (stamp_repair.hpp), and say so.
  bool repair_stamps = true;
  /// As the scans come, without a look at the next ones: what a live run does.
  bool repair_at_once = false;
  /// Scans a second where nothing else gives stamps [Hz]; 0: unknown.
  double rate_hz = 0.0;
  /// File of stamps, one line a scan; empty: looked for beside the scans.
  std::filesystem::path stamps_file;
  /// Name of such a file that goes before others that are there.
  std::string stamps_name;
  /// Turn KITTI's HDL-64E points up by 0.205 deg, the known error of its calibration.
  bool kitti_hdl64_correction = false;
  /// Sensor whose packets a capture or bag holds, where they do not say it themselves or say it
  /// wrongly: one of sensors::sensor_names(); empty: found out.
  std::string sensor;
  /// Calibration or metadata file of that sensor; empty: its manual's table.
  std::filesystem::path calibration_file;
  /// Let beams start where they leave the sensor, as with a VLP-16: up to 11.2 mm (of a VLS-128: 27
  /// mm) above or below its centre.
  bool beam_origins = true;
  ReturnChoice dual_return = ReturnChoice::strongest;
  /// Azimuth at which a revolution is cut from the next [deg], in [0, 360). For derived times it is
  /// taken in the points' own frame, counter-clockwise from x.
  double cut_azimuth_deg = 0.0;
  /// Port that the sensor's packets go to in a capture; 0: that of the first LiDAR found.
  std::uint16_t udp_port = 0;
  /// Whether somebody else reads a bag's other topics, which then are not noted as left out.
  bool others_are_read = false;
  /// Whether items have the fields, too, that a scan has no room for (ScanItem::further).
  bool further_fields = false;
};

/// What the clock of a scan's points showed, where their times are absolute or of the LiDAR's own.
struct PointClock {
  std::int64_t first_ns = 0;   ///< at the first return
  std::int64_t origin_ns = 0;  ///< at the instant that times_ns count from
};

/// Where a scan's packets are.
struct CapturedPackets {
  /// Numbers of a capture's frames, of a topic's packets; neighbours may share a packet.
  std::uint64_t first = 0, end = 0;
  std::uint32_t source_address = 0;  ///< of a capture's
  std::uint16_t port = 0;            ///< that they go to
};

/// One scan of a recording, or why there is none: a bad file in a folder does not end the reading.
struct ScanItem {
  std::optional<Scan> scan;
  std::string name;                ///< file name, or "revolution 12"
  std::string error;               ///< why `scan` is empty
  std::string layout;              ///< what is stored: "PCD binary: x f32, y f32, z f32, time f32"
  std::int64_t logged_ns = 0;      ///< when its message was received; 0: not known
  std::string remark;              ///< what is odd about this scan alone: "partial revolution"
  std::size_t dropped_points = 0;  ///< returns left out for want of a usable time
  /// Left out for the same reason, but no returns at all: their time tells nothing.
  std::size_t dropped_not_finite = 0, dropped_zero = 0;
  std::string frame;                  ///< that its message names
  std::vector<FurtherField> further;  ///< fields that the scan has no room for, where wanted
  std::vector<std::string> losses;    ///< what neither those nor the scan hold, where wanted
  double rounded_by = 0.0;            ///< most that a coordinate lost by becoming a float [m]
  std::optional<PointClock> clock;
  std::optional<CapturedPackets> packets;
};

/// Counters of a packet capture so far; all zero for other recordings.
struct CaptureCounts {
  std::size_t packets = 0;           ///< frames in the capture, of any kind
  std::size_t data_packets = 0;      ///< data packets of the sensor that were used
  std::size_t position_packets = 0;  ///< position (GPS) packets, skipped
  std::size_t truncated = 0;         ///< cut by the capture's snap length or malformed, skipped
  std::size_t other = 0;             ///< other traffic, skipped
  std::size_t fragments = 0;         ///< parts of longer datagrams, before their last
  std::size_t reordered = 0;         ///< of the used ones, those that others had overtaken
  std::size_t lost = 0;              ///< missing between used packets, from the sensor's clock
};

/// A sequence of scans, read from front to back.
class Recording {
 public:
  virtual ~Recording() = default;

  /// The next scan, or nothing at the end. Throws ReadError where reading cannot go on.
  [[nodiscard]] virtual std::optional<ScanItem> next() = 0;
  /// Number of scans, where it is known without reading them all.
  [[nodiscard]] virtual std::optional<std::size_t> size() const = 0;
  /// Passes over scans; cheap where they are separate files.
  virtual void skip(std::size_t scans) = 0;
  /// Share of the recording that was read, 0..1.
  [[nodiscard]] virtual double progress() const = 0;
  /// What was found out from values or assumed, one sentence each. May grow while reading.
  [[nodiscard]] virtual const std::vector<std::string>& notes() const = 0;
  /// What kind of recording it is: "folder of 90 PCD files".
  [[nodiscard]] virtual std::string description() const = 0;
  [[nodiscard]] virtual CaptureCounts capture_counts() const { return {}; }
  /// What of it could not be read, or is damaged, besides scans that are items without one: a
  /// sentence each, among the notes, too. May grow while reading.
  [[nodiscard]] virtual std::vector<std::string> losses() const { return {}; }
  /// The topic that the scans are of; empty: there are none.
  [[nodiscard]] virtual std::string topic() const { return {}; }
};

/// Opens a folder of PCD, PLY or KITTI .bin files (also KITTI's folders above them), one such file,
/// a capture (.pcap, .pcapng) of a LiDAR's packets, also in a folder of its own, or a bag: .bag,
/// .db3, .mcap, or a folder of a bag's parts. Throws ReadError.
[[nodiscard]] std::unique_ptr<Recording> open_recording(const std::filesystem::path& path,
                                                        const OpenOptions& options = {});

/// Whether open_recording() would read it as a bag.
[[nodiscard]] bool is_bag_input(const std::filesystem::path& path, const OpenOptions& options);

}  // namespace surefoot::io
