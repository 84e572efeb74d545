// SPDX-License-Identifier: MIT
#include "benchmark/report/webp.h"

#include <memory>
#include <string>

#include <webp/encode.h>
#include <webp/mux.h>

#include "sim/base/check.h"
#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

struct Delete {
  void operator()(WebPAnimEncoder* encoder) const { WebPAnimEncoderDelete(encoder); }
};
using Encoder = std::unique_ptr<WebPAnimEncoder, Delete>;

/// A picture in libwebp's memory.
class Picture {
 public:
  explicit Picture(const sim::Image& image) {
    WebPPictureInit(&picture_);
    picture_.use_argb = 1;
    picture_.width = image.width;
    picture_.height = image.height;
    is_made_ = WebPPictureImportRGB(&picture_, image.pixels.data(), 3 * image.width) != 0;
  }
  ~Picture() { WebPPictureFree(&picture_); }
  Picture(const Picture&) = delete;
  Picture& operator=(const Picture&) = delete;
  Picture(Picture&&) = delete;
  Picture& operator=(Picture&&) = delete;

  bool is_made() const { return is_made_; }
  WebPPicture* get() { return &picture_; }

 private:
  WebPPicture picture_ = {};
  bool is_made_ = false;
};

void Require(bool holds, const Encoder& encoder) {
  if (holds) return;
  throw sim::Error(std::string("a WebP cannot be made: ") +
                   (encoder ? WebPAnimEncoderGetError(encoder.get()) : "out of memory"));
}

Encoder MakeEncoder(const sim::Image& first) {
  WebPAnimEncoderOptions options = {};
  Require(WebPAnimEncoderOptionsInit(&options) != 0, {});
  options.allow_mixed = 1;  // drawings without losses where that is smaller
  Encoder encoder(WebPAnimEncoderNew(first.width, first.height, &options));
  Require(encoder != nullptr, encoder);
  return encoder;
}

}  // namespace

std::vector<std::uint8_t> ToAnimatedWebp(std::span<const AnimationFrame> frames, float quality) {
  BULLETNAV_CHECK(!frames.empty());
  const sim::Image& first = frames.front().image;
  const Encoder encoder = MakeEncoder(first);
  WebPConfig config = {};
  Require(WebPConfigPreset(&config, WEBP_PRESET_PICTURE, quality) != 0, encoder);
  int time_ms = 0;
  for (const AnimationFrame& frame : frames) {
    BULLETNAV_CHECK(frame.image.width == first.width && frame.image.height == first.height);
    Picture picture(frame.image);
    Require(picture.is_made(), encoder);
    Require(WebPAnimEncoderAdd(encoder.get(), picture.get(), time_ms, &config) != 0, encoder);
    time_ms += frame.milliseconds;
  }
  Require(WebPAnimEncoderAdd(encoder.get(), nullptr, time_ms, nullptr) != 0, encoder);
  WebPData data = {};
  WebPDataInit(&data);
  const bool is_made = WebPAnimEncoderAssemble(encoder.get(), &data) != 0;
  std::vector<std::uint8_t> bytes(data.bytes, data.bytes + data.size);
  WebPDataClear(&data);
  Require(is_made, encoder);
  return bytes;
}

}  // namespace bulletnav::bench
