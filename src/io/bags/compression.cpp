// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/bags/compression.hpp"

#include <bzlib.h>
#include <lz4frame.h>
#include <zlib.h>
#include <zstd.h>

#include <algorithm>
#include <array>
#include <new>
#include <stdexcept>

#include "io/bags/message_source.hpp"
#include "io/recording.hpp"

namespace surefoot::io {
namespace {

/// How far one step of a decoder came.
struct Step {
  std::size_t consumed = 0;
  std::size_t produced = 0;
};

class Zstd {
 public:
  Step step(std::span<const std::byte> in, std::span<std::byte> out) {
    ZSTD_inBuffer from{in.data(), in.size(), 0};
    ZSTD_outBuffer to{out.data(), out.size(), 0};
    const std::size_t result = ZSTD_decompressStream(context_.get(), &to, &from);
    if (ZSTD_isError(result) != 0) {
      throw ReadError(std::string("zstd: ") + ZSTD_getErrorName(result));
    }
    return {from.pos, to.pos};
  }

 private:
  struct Free {
    void operator()(ZSTD_DStream* context) const { ZSTD_freeDStream(context); }
  };
  std::unique_ptr<ZSTD_DStream, Free> context_{ZSTD_createDStream()};
};

class Lz4 {
 public:
  Lz4() { LZ4F_createDecompressionContext(&context_, LZ4F_VERSION); }
  ~Lz4() { LZ4F_freeDecompressionContext(context_); }
  Lz4(const Lz4&) = delete;
  Lz4& operator=(const Lz4&) = delete;

  Step step(std::span<const std::byte> in, std::span<std::byte> out) {
    std::size_t consumed = in.size();
    std::size_t produced = out.size();
    const std::size_t result =
        LZ4F_decompress(context_, out.data(), &produced, in.data(), &consumed, nullptr);
    if (LZ4F_isError(result) != 0) {
      throw ReadError(std::string("lz4: ") + LZ4F_getErrorName(result));
    }
    return {consumed, produced};
  }

 private:
  LZ4F_dctx* context_ = nullptr;
};

class Bzip2 {
 public:
  Bzip2() { BZ2_bzDecompressInit(&state_, 0, 0); }
  ~Bzip2() { BZ2_bzDecompressEnd(&state_); }
  Bzip2(const Bzip2&) = delete;
  Bzip2& operator=(const Bzip2&) = delete;

  Step step(std::span<const std::byte> in, std::span<std::byte> out) {
    if (ended_ && !in.empty()) {  // another stream follows
      BZ2_bzDecompressEnd(&state_);
      state_ = {};
      BZ2_bzDecompressInit(&state_, 0, 0);
      ended_ = false;
    }
    state_.next_in = const_cast<char*>(reinterpret_cast<const char*>(in.data()));
    state_.avail_in = static_cast<unsigned>(in.size());
    state_.next_out = reinterpret_cast<char*>(out.data());
    state_.avail_out = static_cast<unsigned>(out.size());
    const int result = ended_ ? BZ_STREAM_END : BZ2_bzDecompress(&state_);
    if (result != BZ_OK && result != BZ_STREAM_END) {
      throw ReadError("bzip2: the data are damaged (" + std::to_string(result) + ")");
    }
    ended_ = result == BZ_STREAM_END;
    return {in.size() - state_.avail_in, out.size() - state_.avail_out};
  }

 private:
  bz_stream state_{};
  bool ended_ = false;
};

class Gzip {
 public:
  Gzip() { inflateInit2(&state_, kGzipOnly); }
  ~Gzip() { inflateEnd(&state_); }
  Gzip(const Gzip&) = delete;
  Gzip& operator=(const Gzip&) = delete;

  Step step(std::span<const std::byte> in, std::span<std::byte> out) {
    if (ended_ && !in.empty()) {  // another member follows
      inflateReset(&state_);
      ended_ = false;
    }
    state_.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(in.data()));
    state_.avail_in = static_cast<unsigned>(in.size());
    state_.next_out = reinterpret_cast<Bytef*>(out.data());
    state_.avail_out = static_cast<unsigned>(out.size());
    const int result = ended_ ? Z_STREAM_END : inflate(&state_, Z_NO_FLUSH);
    if (result != Z_OK && result != Z_STREAM_END && result != Z_BUF_ERROR) {
      throw ReadError("gzip: the data are damaged (" + std::to_string(result) + ")");
    }
    ended_ = result == Z_STREAM_END;
    return {in.size() - state_.avail_in, out.size() - state_.avail_out};
  }

 private:
  static constexpr int kGzipOnly = 15 + 16;
  z_stream state_{};
  bool ended_ = false;
};

template <typename Decoder>
class DecompressingStream final : public ByteStream {
 public:
  explicit DecompressingStream(ByteStream& compressed) : compressed_(compressed) {}

  std::size_t read(std::span<std::byte> to) override {
    std::size_t done = 0;
    while (done < to.size()) {
      refill();
      constexpr std::size_t kMostAtOnce = 1 << 30;  // bzip2 and zlib count in 32 bits
      const Step step =
          decoder_.step(rest_, to.subspan(done, std::min(to.size() - done, kMostAtOnce)));
      rest_ = rest_.subspan(step.consumed);
      done += step.produced;
      if (step.consumed == 0 && step.produced == 0) break;
    }
    return done;
  }

 private:
  void refill() {
    if (!rest_.empty()) return;
    rest_ = std::span<const std::byte>(buffer_).first(compressed_.read(buffer_));
  }

  ByteStream& compressed_;
  Decoder decoder_;
  std::array<std::byte, 65'536> buffer_;
  std::span<const std::byte> rest_;
};

/// A file that is compressed as a whole.
class CompressedFile final : public ByteStream {
 public:
  CompressedFile(const std::filesystem::path& file, Compression compression)
      : file_(file), inside_(decompress(compression, file_)) {}
  std::size_t read(std::span<std::byte> to) override { return inside_->read(to); }
  double progress() const override { return file_.progress(); }

 private:
  FileStream file_;
  std::unique_ptr<ByteStream> inside_;
};

std::string compress_lz4(std::string_view bytes) {
  std::string frame(LZ4F_compressFrameBound(bytes.size(), nullptr), '\0');
  const std::size_t size =
      LZ4F_compressFrame(frame.data(), frame.size(), bytes.data(), bytes.size(), nullptr);
  if (LZ4F_isError(size) != 0) throw std::runtime_error(LZ4F_getErrorName(size));
  frame.resize(size);
  return frame;
}

std::string compress_zstd(std::string_view bytes) {
  constexpr int kFast = 1;
  std::string frame(ZSTD_compressBound(bytes.size()), '\0');
  const std::size_t size =
      ZSTD_compress(frame.data(), frame.size(), bytes.data(), bytes.size(), kFast);
  if (ZSTD_isError(size) != 0) throw std::runtime_error(ZSTD_getErrorName(size));
  frame.resize(size);
  return frame;
}

}  // namespace

std::optional<Compression> compression_named(std::string_view name) {
  if (name.empty() || name == "none") return Compression::none;
  if (name == "lz4") return Compression::lz4;
  if (name == "zstd") return Compression::zstd;
  if (name == "bz2") return Compression::bzip2;
  return std::nullopt;
}

std::unique_ptr<ByteStream> decompress(Compression compression, ByteStream& compressed) {
  switch (compression) {
    case Compression::lz4:
      return std::make_unique<DecompressingStream<Lz4>>(compressed);
    case Compression::zstd:
      return std::make_unique<DecompressingStream<Zstd>>(compressed);
    case Compression::bzip2:
      return std::make_unique<DecompressingStream<Bzip2>>(compressed);
    case Compression::gzip:
      return std::make_unique<DecompressingStream<Gzip>>(compressed);
    case Compression::none:
      break;
  }
  throw std::invalid_argument("nothing to decompress");
}

std::uint64_t most_from(std::uint64_t compressed) {
  constexpr std::uint64_t kSmall = 64 << 20, kLargestRatio = 32;
  return std::max(kSmall, kLargestRatio * (compressed + 1));
}

bool is_zstd(std::span<const std::byte> bytes) {
  constexpr std::array<std::byte, 4> kMagic = {std::byte{0x28}, std::byte{0xb5}, std::byte{0x2f},
                                               std::byte{0xfd}};
  return bytes.size() >= kMagic.size() && std::equal(kMagic.begin(), kMagic.end(), bytes.begin());
}

Compression compression_by_content(std::span<const std::byte> begin) {
  using namespace std::string_view_literals;
  const std::string_view text(reinterpret_cast<const char*>(begin.data()), begin.size());
  if (is_zstd(begin)) return Compression::zstd;
  if (text.starts_with("\x1f\x8b\x08"sv)) return Compression::gzip;
  if (text.starts_with("\x04\x22\x4d\x18"sv)) return Compression::lz4;
  const bool bzip2 = text.starts_with("BZh"sv) &&
                     text.substr(std::min<std::size_t>(text.size(), 4)).starts_with("1AY&SY"sv);
  return bzip2 ? Compression::bzip2 : Compression::none;
}

std::unique_ptr<ByteStream> open_stream(const std::filesystem::path& file) {
  std::array<std::byte, 16> begin{};
  const std::size_t got = FileStream(file).read(begin);
  const Compression compression = compression_by_content(std::span(begin).first(got));
  if (compression == Compression::none) return std::make_unique<FileStream>(file);
  return std::make_unique<CompressedFile>(file, compression);
}

std::optional<std::span<const std::byte>> CompressedMessages::plain(
    std::span<const std::byte> message) {
  if (!is_zstd(message)) return message;
  any_ = true;
  MemoryStream frame(message);
  const std::unique_ptr<ByteStream> content = decompress(Compression::zstd, frame);
  try {
    const std::uint64_t honest = most_from(message.size());
    const std::span<const std::byte> plain =
        read_all(*content, plain_, std::min(honest + 1, kMostMessageBytes));
    const bool dense = plain.size() > honest;
    if (!dense && plain.size() < kMostMessageBytes) return plain;
    problem_ = dense ? kTooDense : "it decompresses to more than 256 MiB";
    plain_ = {};
  } catch (const std::bad_alloc&) {
    problem_ = "it takes more memory than there is";
  } catch (const ReadError& error) {
    problem_ = error.what();
  }
  return std::nullopt;
}

std::string compress(Compression compression, std::string_view bytes) {
  switch (compression) {
    case Compression::lz4:
      return compress_lz4(bytes);
    case Compression::zstd:
      return compress_zstd(bytes);
    case Compression::none:
      return std::string(bytes);
    case Compression::bzip2:
    case Compression::gzip:
      break;
  }
  throw std::invalid_argument("neither bzip2 nor gzip is written");
}

}  // namespace surefoot::io
