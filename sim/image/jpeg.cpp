// SPDX-License-Identifier: MIT
#include <cstdio>
// jpeglib.h uses FILE and size_t without including them.
#include <algorithm>
#include <csetjmp>
#include <cstdlib>
#include <optional>

#include <jpeglib.h>

#include "sim/base/error.h"
#include "sim/image/codecs.h"
#include "sim/image/image.h"

namespace bulletnav::sim {
namespace {

struct JpegError {
  jpeg_error_mgr manager;  // first: libjpeg hands us a pointer to it
  std::jmp_buf jump;
  char message[JMSG_LENGTH_MAX];
};

[[noreturn]] void OnError(j_common_ptr info) {
  auto* error = reinterpret_cast<JpegError*>(info->err);
  info->err->format_message(info, error->message);
  std::longjmp(error->jump, 1);
}

void OnMessage(j_common_ptr) {}

void Install(JpegError* error) {
  jpeg_std_error(&error->manager);
  error->manager.error_exit = OnError;
  error->manager.output_message = OnMessage;
}

class JpegDecoder {
 public:
  JpegDecoder() {
    Install(&error_);
    info_.err = &error_.manager;
    jpeg_create_decompress(&info_);
  }
  ~JpegDecoder() { jpeg_destroy_decompress(&info_); }
  JpegDecoder(const JpegDecoder&) = delete;
  JpegDecoder& operator=(const JpegDecoder&) = delete;
  JpegDecoder(JpegDecoder&&) = delete;
  JpegDecoder& operator=(JpegDecoder&&) = delete;

  Image Decode(std::span<const std::uint8_t> bytes, std::uint64_t most_pixels) {
    if (setjmp(error_.jump) != 0) throw ImageError(std::string("damaged JPEG: ") + error_.message);
    jpeg_mem_src(&info_, bytes.data(), bytes.size());
    jpeg_read_header(&info_, TRUE);
    shrink_ = ShrinkOf(info_.image_width, info_.image_height, most_pixels);
    // The inverse transform gives blocks of 4 x 4, 2 x 2 or 1 pixels at next to no cost; sides are
    // rounded up, as ours.
    info_.scale_num = 1;
    info_.scale_denom = static_cast<unsigned>(std::min(shrink_, kMostByTransform));
    info_.out_color_space = JCS_EXT_RGBA;
    jpeg_start_decompress(&info_);
    rows_.emplace(static_cast<int>(info_.output_width), static_cast<int>(info_.output_height),
                  std::max(1, shrink_ / kMostByTransform));
    row_.resize(std::size_t{4} * info_.output_width);
    while (info_.output_scanline < info_.output_height) {
      JSAMPROW row = row_.data();
      jpeg_read_scanlines(&info_, &row, 1);
      rows_->Add(row_);
    }
    if (error_.manager.num_warnings > 0) throw ImageError("damaged JPEG: file ends early");
    jpeg_finish_decompress(&info_);
    return rows_->Take();
  }

 private:
  static constexpr int kMostByTransform = 8;

  JpegError error_{};
  // Members: a longjmp out of libjpeg leaves locals undefined.
  int shrink_ = 1;
  std::vector<std::uint8_t> row_;
  std::optional<RowAverager> rows_;
  jpeg_decompress_struct info_{};
};

class JpegEncoder {
 public:
  JpegEncoder() {
    Install(&error_);
    info_.err = &error_.manager;
    jpeg_create_compress(&info_);
  }
  ~JpegEncoder() {
    jpeg_destroy_compress(&info_);
    std::free(buffer_);  // NOLINT(cppcoreguidelines-owning-memory): jpeg_mem_dest mallocs it
  }
  JpegEncoder(const JpegEncoder&) = delete;
  JpegEncoder& operator=(const JpegEncoder&) = delete;
  JpegEncoder(JpegEncoder&&) = delete;
  JpegEncoder& operator=(JpegEncoder&&) = delete;

  std::vector<std::uint8_t> Encode(const Image& image, int quality) {
    if (setjmp(error_.jump) != 0) throw ImageError(error_.message);
    jpeg_mem_dest(&info_, &buffer_, &size_);
    info_.image_width = static_cast<JDIMENSION>(image.width);
    info_.image_height = static_cast<JDIMENSION>(image.height);
    info_.input_components = 3;
    info_.in_color_space = JCS_RGB;
    jpeg_set_defaults(&info_);
    jpeg_set_quality(&info_, quality, TRUE);
    info_.comp_info[0].h_samp_factor = 1;
    info_.comp_info[0].v_samp_factor = 1;
    jpeg_start_compress(&info_, TRUE);
    while (info_.next_scanline < info_.image_height) {
      JSAMPROW row = const_cast<JSAMPROW>(image.at(0, static_cast<int>(info_.next_scanline)));
      jpeg_write_scanlines(&info_, &row, 1);
    }
    jpeg_finish_compress(&info_);
    return {buffer_, buffer_ + size_};
  }

 private:
  JpegError error_{};
  jpeg_compress_struct info_{};
  unsigned char* buffer_ = nullptr;
  unsigned long size_ = 0;  // NOLINT(google-runtime-int): libjpeg's type
};

}  // namespace

Image DecodeJpeg(std::span<const std::uint8_t> bytes, std::uint64_t most_pixels) {
  return JpegDecoder().Decode(bytes, most_pixels);
}

std::vector<std::uint8_t> EncodeJpeg(const Image& image, int quality) {
  if (image.channels != 3) throw Error("only RGB pictures can be written as JPEG");
  return JpegEncoder().Encode(image, quality);
}

}  // namespace bulletnav::sim
