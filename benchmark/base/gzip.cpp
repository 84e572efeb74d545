// SPDX-License-Identifier: MIT
#include "benchmark/base/gzip.h"

#include <algorithm>
#include <array>
#include <limits>

#include <zlib.h>

#include "sim/base/check.h"
#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

using sim::Error;

constexpr int kGzipFormat = 15 + 16;  // zlib's largest window, with gzip's header
constexpr int kMemoryLevel = 8;       // zlib's default
constexpr std::size_t kBlock = 1u << 16;
constexpr std::size_t kMostText = std::size_t{2} << 30;

/// zlib reads from const memory through a pointer to mutable bytes.
Bytef* Input(const void* data) {
  return const_cast<Bytef*>(static_cast<const Bytef*>(data));
}

uInt InputSize(std::size_t size) {
  return static_cast<uInt>(std::min<std::size_t>(size, std::numeric_limits<uInt>::max()));
}

class Inflater {
 public:
  Inflater() { BULLETNAV_CHECK_EQ(inflateInit2(&stream_, kGzipFormat), Z_OK); }
  ~Inflater() { inflateEnd(&stream_); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;
  Inflater(Inflater&&) = delete;
  Inflater& operator=(Inflater&&) = delete;

  /// Unpacks one member to the end of `text`; returns the bytes behind it.
  std::span<const std::uint8_t> Member(std::span<const std::uint8_t> bytes, std::string* text) {
    BULLETNAV_CHECK_EQ(inflateReset(&stream_), Z_OK);
    bool is_over = false;
    while (!is_over) {
      if (bytes.empty()) throw Error("the gzip data is cut off; copy or download the file again");
      stream_.next_in = Input(bytes.data());
      stream_.avail_in = InputSize(bytes.size());
      const uInt given = stream_.avail_in;
      is_over = Drain(text);
      bytes = bytes.subspan(given - stream_.avail_in);
    }
    return bytes;
  }

 private:
  /// Unpacks what was given; true at the end of the member.
  bool Drain(std::string* text) {
    std::array<char, kBlock> block{};
    do {
      stream_.next_out = reinterpret_cast<Bytef*>(block.data());
      stream_.avail_out = static_cast<uInt>(block.size());
      const int status = inflate(&stream_, Z_NO_FLUSH);
      if (status != Z_OK && status != Z_STREAM_END && status != Z_BUF_ERROR) {
        throw Error("the gzip data is damaged; copy or download the file again");
      }
      text->append(block.data(), block.size() - stream_.avail_out);
      if (text->size() > kMostText) throw Error("unpacks to over 2 GiB; split the file");
      if (status == Z_STREAM_END) return true;
    } while (stream_.avail_out == 0);
    return false;
  }

  z_stream stream_{};
};

}  // namespace

bool IsGzip(std::span<const std::uint8_t> bytes) {
  return bytes.size() >= 2 && bytes[0] == 0x1f && bytes[1] == 0x8b;
}

std::vector<std::uint8_t> Compress(std::string_view text) {
  BULLETNAV_CHECK_LE(text.size(), kMostText);
  z_stream stream{};
  BULLETNAV_CHECK_EQ(deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, kGzipFormat,
                                  kMemoryLevel, Z_DEFAULT_STRATEGY),
                     Z_OK);
  std::vector<std::uint8_t> bytes(deflateBound(&stream, text.size()));
  stream.next_in = Input(text.data());
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = bytes.data();
  stream.avail_out = static_cast<uInt>(bytes.size());
  BULLETNAV_CHECK_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  bytes.resize(stream.total_out);
  deflateEnd(&stream);
  return bytes;
}

std::string Decompress(std::span<const std::uint8_t> bytes) {
  Inflater inflater;
  std::string text;
  while (!bytes.empty()) bytes = inflater.Member(bytes, &text);
  return text;
}

}  // namespace bulletnav::bench
