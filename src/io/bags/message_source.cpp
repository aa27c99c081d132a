// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/bags/message_source.hpp"

#include <algorithm>
#include <new>

#include "io/bags/compression.hpp"
#include "text/printable.hpp"

namespace surefoot::io {
namespace {

// A message that ends once it has become too large for what it was compressed into.
class DensityWatch final : public ByteStream {
 public:
  DensityWatch(LimitedStream& record, const CompressedSource& source)
      : record_(record), source_(source), compressed_before_(source.compressed.left()) {}

  std::size_t read(std::span<std::byte> to) override {
    constexpr std::size_t kStep = 8 << 20;
    std::size_t done = 0;
    while (done < to.size() && !too_dense_) {
      const std::size_t wanted = std::min(kStep, to.size() - done);
      const std::size_t got = record_.read(to.subspan(done, wanted));
      done += got;
      plain_ += got;
      too_dense_ =
          plain_ > most_from(compressed_before_ - source_.compressed.left() + source_.read_ahead);
      if (got < wanted) break;
    }
    return done;
  }
  [[nodiscard]] bool is_too_dense() const { return too_dense_; }

 private:
  LimitedStream& record_;
  const CompressedSource& source_;
  std::uint64_t compressed_before_;
  std::uint64_t plain_ = 0;
  bool too_dense_ = false;
};

}  // namespace

void MessageSource::note(std::string_view text) {
  const std::size_t before = notes_.size();
  note_harmless(text);
  if (notes_.size() > before) losses_.push_back(notes_.back());
}

void MessageSource::note_harmless(std::string_view text) {
  constexpr std::size_t kMostNotes = 20;
  if (notes_.size() >= kMostNotes) return;
  if (std::find(notes_.begin(), notes_.end(), text) != notes_.end()) return;
  notes_.emplace_back(notes_.size() + 1 < kMostNotes ? text : "more of the kind is not listed");
}

void MessageSource::announce(const Topic& topic) {
  constexpr std::size_t kMostTopics = 1000;
  const auto is_same = [&](const Topic& one) {
    return one.name == topic.name && one.type == topic.type;
  };
  if (announced_.size() >= kMostTopics) return;
  if (std::none_of(announced_.begin(), announced_.end(), is_same)) announced_.push_back(topic);
}

std::shared_ptr<const TopicDefinition> MessageSource::keep(TopicDefinition definition) {
  constexpr std::size_t kMostBytes = 32 << 20;
  definition.type.resize(std::min(definition.type.size(), kMostNameBytes));
  const std::size_t bytes = definition.text.size() + definition.qos.size() + definition.md5.size() +
                            definition.language.size();
  if (bytes > kMostBytes - definition_bytes_) {
    return std::make_shared<TopicDefinition>(
        TopicDefinition{std::move(definition.type), "", "", "", "", definition.latched});
  }
  definition_bytes_ += bytes;
  return std::make_shared<TopicDefinition>(std::move(definition));
}

void MessageSource::note_lost(const Topic& topic, std::string_view why) {
  note("a message of " + text::printable(topic.name) + " is passed over: " + std::string(why));
}

std::optional<std::span<const std::byte>> MessageSource::read_message_bytes(
    const Topic& topic, LimitedStream& record, const CompressedSource* source,
    std::vector<std::byte>& buffer) {
  const std::string size = std::to_string(record.left()) + " bytes";
  if (record.left() > kMostMessageBytes) {
    note_lost(topic, size + "; expected at most 256 MiB");
    return std::nullopt;
  }
  try {
    const std::uint64_t whole = record.left();
    if (source == nullptr) return read_bytes(record, whole, buffer);
    DensityWatch watch(record, *source);
    const auto bytes = read_bytes(watch, whole, buffer);
    if (!watch.is_too_dense()) return bytes;
    buffer = {};
    note_lost(topic, kTooDense);
    record.skip(record.left());
    return std::nullopt;
  } catch (const std::bad_alloc&) {
    note_lost(topic, size + " take more memory than there is");
    return std::nullopt;
  }
}

bool is_latched_qos(std::string_view qos) {
  // rmw's number of it until Iron, its name since.
  return qos.find("durability: 1") != std::string_view::npos ||
         qos.find("durability: transient_local") != std::string_view::npos;
}

std::string plain_type_name(std::string_view name) {
  std::string plain;
  while (!name.empty()) {  // its parts, but "msg" and "dds_"
    const std::size_t end = std::min(name.find_first_of("/:"), name.size());
    const std::string_view part = name.substr(0, end);
    if (!part.empty() && part != "msg" && part != "dds_") {
      if (!plain.empty()) plain.push_back('/');
      plain.append(part);
    }
    name.remove_prefix(std::min(end + 1, name.size()));
  }
  if (plain.ends_with('_')) plain.pop_back();  // DDS has it behind the names of types
  return plain;
}

}  // namespace surefoot::io
