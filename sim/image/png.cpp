// SPDX-License-Identifier: MIT
#include <csetjmp>
#include <cstring>
#include <optional>

#include <png.h>

#include "sim/base/error.h"
#include "sim/image/codecs.h"
#include "sim/image/image.h"

namespace bulletnav::sim {
namespace {

/// libpng's state for one direction; errors become ImageError after libpng has unwound.
struct PngError {
  std::string message;
};

[[noreturn]] void OnError(png_structp png, png_const_charp message) {
  auto* error = static_cast<PngError*>(png_get_error_ptr(png));
  if (error != nullptr) error->message = message;
  png_longjmp(png, 1);
}

void OnWarning(png_structp, png_const_charp) {}

class PngReader {
 public:
  explicit PngReader(std::span<const std::uint8_t> bytes) : left_(bytes) {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, &error_, OnError, OnWarning);
    info_ = png_create_info_struct(png_);
    png_set_read_fn(png_, this, Read);
    png_set_user_limits(png_, kMostPixels, kMostPixels);
  }
  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
  PngReader(PngReader&&) = delete;
  PngReader& operator=(PngReader&&) = delete;

  Image ReadRgba(std::uint64_t most_pixels) {
    if (setjmp(png_jmpbuf(png_)) != 0) throw ImageError("damaged PNG: " + error_.message);
    ReadHeader();
    const auto width = static_cast<std::uint64_t>(width_);
    averager_.emplace(width_, height_,
                      ShrinkOf(width, static_cast<std::uint64_t>(height_), most_pixels));
    png_set_expand(png_);
    png_set_scale_16(png_);
    png_set_gray_to_rgb(png_);
    png_set_add_alpha(png_, 0xff, PNG_FILLER_AFTER);
    const bool is_interlaced = png_set_interlace_handling(png_) > 1;
    png_read_update_info(png_, info_);
    row_.resize(4 * width);
    if (png_get_rowbytes(png_, info_) != row_.size()) png_error(png_, "unknown pixel layout");
    if (is_interlaced) ReadInterlaced();
    for (int y = 0; y < height_; ++y) {
      if (!is_interlaced) png_read_row(png_, row_.data(), nullptr);
      averager_->Add(is_interlaced ? std::span<const std::uint8_t>(image_.at(0, y), row_.size())
                                   : std::span<const std::uint8_t>(row_));
    }
    return averager_->Take();
  }

  std::vector<std::uint16_t> ReadGrey16() {
    if (setjmp(png_jmpbuf(png_)) != 0) throw ImageError("damaged PNG: " + error_.message);
    ReadHeader();
    if (png_get_bit_depth(png_, info_) != 16 ||
        png_get_color_type(png_, info_) != PNG_COLOR_TYPE_GRAY) {
      png_error(png_, "not 16-bit grey");
    }
    png_set_swap(png_);
    const auto width = static_cast<std::size_t>(width_);
    values_.resize(width * static_cast<std::size_t>(height_));
    for (std::size_t start = 0; start < values_.size(); start += width) {
      rows_.push_back(reinterpret_cast<png_bytep>(&values_[start]));
    }
    png_read_image(png_, rows_.data());
    return std::move(values_);
  }

  int width() const { return width_; }
  int height() const { return height_; }

 private:
  static void Read(png_structp png, png_bytep out, std::size_t size) {
    auto* self = static_cast<PngReader*>(png_get_io_ptr(png));
    if (size > self->left_.size()) png_error(png, "file ends early");
    std::memcpy(out, self->left_.data(), size);
    self->left_ = self->left_.subspan(size);
  }

  void ReadHeader() {
    png_read_info(png_, info_);
    const std::uint64_t w = png_get_image_width(png_, info_);
    const std::uint64_t h = png_get_image_height(png_, info_);
    ShrinkOf(w, h, kMostPixels);
    width_ = static_cast<int>(w);
    height_ = static_cast<int>(h);
  }

  /// Rows come again and again, a few more pixels each time.
  void ReadInterlaced() {
    image_ = Image(width_, height_, 4);
    for (int y = 0; y < height_; ++y) rows_.push_back(image_.at(0, y));
    png_read_image(png_, rows_.data());
  }

  // Members, not locals: a longjmp out of libpng leaves locals undefined.
  PngError error_;
  std::span<const std::uint8_t> left_;
  int width_ = 0;
  int height_ = 0;
  Image image_;
  std::vector<std::uint8_t> row_;
  std::optional<RowAverager> averager_;
  std::vector<std::uint16_t> values_;
  std::vector<png_bytep> rows_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};

class PngWriter {
 public:
  PngWriter() {
    png_ = png_create_write_struct(PNG_LIBPNG_VER_STRING, &error_, OnError, OnWarning);
    info_ = png_create_info_struct(png_);
    png_set_write_fn(png_, &out_, Append, nullptr);
    png_set_compression_level(png_, 4);
  }
  ~PngWriter() { png_destroy_write_struct(&png_, &info_); }
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;
  PngWriter(PngWriter&&) = delete;
  PngWriter& operator=(PngWriter&&) = delete;

  std::vector<std::uint8_t> Write(std::vector<png_bytep> rows, int width, int color_type,
                                  int bit_depth) {
    if (setjmp(png_jmpbuf(png_)) != 0) throw ImageError("cannot encode PNG: " + error_.message);
    png_set_IHDR(png_, info_, static_cast<png_uint_32>(width),
                 static_cast<png_uint_32>(rows.size()), bit_depth, color_type, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png_, info_);
    if (bit_depth == 16) png_set_swap(png_);
    png_write_image(png_, rows.data());
    png_write_end(png_, info_);
    return std::move(out_);
  }

 private:
  static void Append(png_structp png, png_bytep data, std::size_t size) {
    auto* out = static_cast<std::vector<std::uint8_t>*>(png_get_io_ptr(png));
    out->insert(out->end(), data, data + size);
  }

  PngError error_;
  std::vector<std::uint8_t> out_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};

}  // namespace

Image DecodePng(std::span<const std::uint8_t> bytes, std::uint64_t most_pixels) {
  return PngReader(bytes).ReadRgba(most_pixels);
}

std::vector<std::uint16_t> DecodePng16(std::span<const std::uint8_t> bytes, int* width,
                                       int* height) {
  PngReader reader(bytes);
  std::vector<std::uint16_t> values = reader.ReadGrey16();
  *width = reader.width();
  *height = reader.height();
  return values;
}

std::vector<std::uint8_t> EncodePng(const Image& image) {
  if (image.channels != 1 && image.channels != 3 && image.channels != 4) {
    throw Error("only grey, RGB and RGBA pictures can be written as PNG");
  }
  const int color_type = image.channels == 1   ? PNG_COLOR_TYPE_GRAY
                         : image.channels == 3 ? PNG_COLOR_TYPE_RGB
                                               : PNG_COLOR_TYPE_RGB_ALPHA;
  std::vector<png_bytep> rows;
  rows.reserve(static_cast<std::size_t>(image.height));
  for (int y = 0; y < image.height; ++y) rows.push_back(const_cast<png_bytep>(image.at(0, y)));
  return PngWriter().Write(std::move(rows), image.width, color_type, 8);
}

std::vector<std::uint8_t> EncodePng16(std::span<const std::uint16_t> values, int width,
                                      int height) {
  if (values.size() != static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
    throw Error("a grey picture has not as many values as its size says");
  }
  std::vector<png_bytep> rows;
  for (int y = 0; y < height; ++y) {
    const auto* row = &values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width)];
    rows.push_back(reinterpret_cast<png_bytep>(const_cast<std::uint16_t*>(row)));
  }
  return PngWriter().Write(std::move(rows), width, PNG_COLOR_TYPE_GRAY, 16);
}

}  // namespace bulletnav::sim
