// SPDX-License-Identifier: MIT
#include "sim/image/image.h"

#include <algorithm>
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>
#include <webp/encode.h>
#include <zlib.h>

#include "sim/base/error.h"
#include "sim/image/decode.h"
#include "sim/math/rng.h"

namespace bulletnav::sim {
namespace {

Image Noise(int width, int height, int channels) {
  Rng rng(1, "image");
  Image image(width, height, channels);
  for (std::uint8_t& p : image.pixels) p = static_cast<std::uint8_t>(rng.Below(256));
  return image;
}

TEST(Image, PngKeepsEveryPixel) {
  for (const int channels : {1, 3, 4}) {
    const Image image = Noise(13, 7, channels);
    const Image back = DecodeImage(EncodePng(image));
    ASSERT_EQ(back.width, 13);
    ASSERT_EQ(back.height, 7);
    for (int y = 0; y < 7; ++y) {
      for (int x = 0; x < 13; ++x) {
        const std::uint8_t* a = image.at(x, y);
        const std::uint8_t* b = back.at(x, y);
        for (int c = 0; c < 3; ++c) EXPECT_EQ(b[c], a[channels == 1 ? 0 : c]);
        EXPECT_EQ(b[3], channels == 4 ? a[3] : 255);
      }
    }
  }
}

TEST(Image, Png16KeepsEveryValue) {
  Rng rng(2, "depth");
  std::vector<std::uint16_t> values(5 * 9);
  for (auto& v : values) v = static_cast<std::uint16_t>(rng.Next());
  int width = 0;
  int height = 0;
  EXPECT_EQ(DecodePng16(EncodePng16(values, 5, 9), &width, &height), values);
  EXPECT_EQ(width, 5);
  EXPECT_EQ(height, 9);
  EXPECT_THROW(DecodePng16(EncodePng(Noise(4, 4, 3)), &width, &height), ImageError);
}

TEST(Image, JpegComesNear) {
  Image image(64, 64, 3);
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      image.at(x, y)[0] = static_cast<std::uint8_t>(4 * x);
      image.at(x, y)[1] = static_cast<std::uint8_t>(4 * y);
      image.at(x, y)[2] = 100;
    }
  }
  const Image back = DecodeImage(EncodeJpeg(image, 92));
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(back.at(x, y)[c], image.at(x, y)[c], 12);
    }
  }
}

TEST(Image, BmpAndTgaAreRead) {
  // 2 x 1 pixels, blue then red, 24 bits.
  const std::vector<std::uint8_t> bmp = {'B', 'M', 62, 0, 0, 0, 0,   0, 0, 0, 54, 0,   0,  0, 40, 0,
                                         0,   0,   2,  0, 0, 0, 1,   0, 0, 0, 1,  0,   24, 0, 0,  0,
                                         0,   0,   8,  0, 0, 0, 0,   0, 0, 0, 0,  0,   0,  0, 0,  0,
                                         0,   0,   0,  0, 0, 0, 255, 0, 0, 0, 0,  255, 0,  0};
  const std::vector<std::uint8_t> tga = {0, 0, 2, 0, 0,  0, 0,   0, 0, 0, 0, 0,
                                         2, 0, 1, 0, 24, 0, 255, 0, 0, 0, 0, 255};
  for (const auto& bytes : {bmp, tga}) {
    const Image image = DecodeImage(bytes);
    ASSERT_EQ(image.width, 2);
    EXPECT_EQ(image.at(0, 0)[2], 255);
    EXPECT_EQ(image.at(1, 0)[0], 255);
    EXPECT_EQ(image.at(1, 0)[3], 255);
  }
}

TEST(Image, DamagedFilesThrow) {
  const std::vector<std::uint8_t> png = EncodePng(Noise(40, 40, 3));
  const std::vector<std::uint8_t> jpeg = EncodeJpeg(Noise(40, 40, 3), 90);
  for (const auto& good : {png, jpeg}) {
    for (const std::size_t length :
         {std::size_t{0}, std::size_t{3}, std::size_t{20}, good.size() / 2, good.size() - 40}) {
      EXPECT_THROW(DecodeImage(std::span(good).first(length)), ImageError) << length;
    }
  }
  EXPECT_THROW(DecodeImage(std::vector<std::uint8_t>(100, 'x')), ImageError);
}

TEST(Image, RandomDamageNeverCrashes) {
  Rng rng(3, "damage");
  const std::vector<std::uint8_t> originals[] = {EncodePng(Noise(20, 20, 4)),
                                                 EncodeJpeg(Noise(20, 20, 3), 90)};
  for (int i = 0; i < 2000; ++i) {
    std::vector<std::uint8_t> bytes = originals[i % 2];
    for (int k = 0; k <= rng.Below(5); ++k) {
      bytes[static_cast<std::size_t>(rng.Below(static_cast<int>(bytes.size())))] =
          static_cast<std::uint8_t>(rng.Next());
    }
    if (rng.Chance(0.3)) bytes.resize(bytes.size() / 2);
    try {
      DecodeImage(bytes);
    } catch (const ImageError&) {
    }
  }
}

TEST(Image, ResizeKeepsTheMeanAndFlatColours) {
  const Image image = Noise(64, 48, 3);
  const auto mean = [](const Image& i) {
    double sum = 0.0;
    for (const std::uint8_t p : i.pixels) sum += p;
    return sum / static_cast<double>(i.pixels.size());
  };
  for (const auto& [w, h] : {std::pair{32, 24}, {16, 16}, {1, 1}, {7, 5}}) {
    EXPECT_NEAR(mean(Resize(image, w, h)), mean(image), 1.0) << w;
  }
  Image flat(10, 10, 4);
  std::fill(flat.pixels.begin(), flat.pixels.end(), std::uint8_t{77});
  for (const std::uint8_t p : Resize(flat, 31, 17).pixels) EXPECT_EQ(p, 77);
}

/// Smooth, so that formats that lose something lose little.
Image Hills(int width, int height) {
  Image image(width, height, 3);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image.at(x, y)[0] = static_cast<std::uint8_t>(std::abs(x % 510 - 255));
      image.at(x, y)[1] = static_cast<std::uint8_t>(std::abs(2 * y % 510 - 255));
      image.at(x, y)[2] = 100;
    }
  }
  return image;
}

/// The slow and simple version.
Image ShrunkByHand(const Image& image, int side) {
  Image small((image.width + side - 1) / side, (image.height + side - 1) / side, image.channels);
  for (int y = 0; y < small.height; ++y) {
    for (int x = 0; x < small.width; ++x) {
      for (int c = 0; c < image.channels; ++c) {
        int sum = 0;
        int count = 0;
        for (int v = y * side; v < std::min(image.height, (y + 1) * side); ++v) {
          for (int u = x * side; u < std::min(image.width, (x + 1) * side); ++u, ++count) {
            sum += image.at(u, v)[c];
          }
        }
        small.at(x, y)[c] = static_cast<std::uint8_t>((sum + count / 2) / count);
      }
    }
  }
  return small;
}

void ExpectNear(const Image& rgba, const Image& rgb, int tolerance) {
  ASSERT_EQ(rgba.width, rgb.width);
  ASSERT_EQ(rgba.height, rgb.height);
  for (int y = 0; y < rgb.height; ++y) {
    for (int x = 0; x < rgb.width; ++x) {
      for (int c = 0; c < 3; ++c) {
        ASSERT_NEAR(rgba.at(x, y)[c], rgb.at(x, y)[c], tolerance) << x << " " << y;
      }
    }
  }
}

std::vector<std::uint8_t> WebpOf(const Image& image, bool lossless) {
  std::uint8_t* bytes = nullptr;
  const int stride = 3 * image.width;
  const std::uint8_t* from = image.pixels.data();
  const std::size_t size =
      lossless ? WebPEncodeLosslessRGB(from, image.width, image.height, stride, &bytes)
               : WebPEncodeRGB(from, image.width, image.height, stride, 95.0f, &bytes);
  std::vector<std::uint8_t> webp(bytes, bytes + size);
  WebPFree(bytes);
  return webp;
}

TEST(Image, WebpIsRead) {
  const Image image = Noise(31, 17, 3);
  ExpectNear(DecodeImage(WebpOf(image, true)), image, 0);
  ExpectNear(DecodeImage(WebpOf(Hills(64, 64), false)), Hills(64, 64), 12);
  const std::vector<std::uint8_t> webp = WebpOf(image, true);
  for (const std::size_t length : {std::size_t{16}, webp.size() / 2, webp.size() - 9}) {
    EXPECT_THROW(DecodeImage(std::span(webp).first(length)), ImageError) << length;
  }
}

TEST(Image, LargePicturesAreHalvedWhileTheyAreDecoded) {
  // 16384 columns, as scans have; rows that no square divides.
  const Image image = Hills(16384, 61);
  const std::vector<std::uint8_t> png = EncodePng(image);
  const std::vector<std::uint8_t> jpeg = EncodeJpeg(image, 95);
  for (const int side : {1, 2, 4, 16}) {
    const Image small = ShrunkByHand(image, side);
    const auto most = std::uint64_t(small.width) * std::uint64_t(small.height);
    ExpectNear(DecodeImage(png, most), small, 0);
    // The last rows of a JPEG's blocks repeat the picture's last; one in 16 of the rows differs.
    const Image from_jpeg = DecodeImage(jpeg, most);
    ASSERT_EQ(from_jpeg.width, small.width);
    ASSERT_EQ(from_jpeg.height, small.height);
    for (int x = 0; x < small.width; x += 7) {
      EXPECT_NEAR(from_jpeg.at(x, 1)[0], small.at(x, 1)[0], 12) << side << " " << x;
    }
  }
  const Image wide = Hills(16383, 61);  // WebP's longest
  ExpectNear(DecodeImage(WebpOf(wide, true), 8192 * 31), ShrunkByHand(wide, 2), 12);
}

TEST(Image, PicturesOfAnySizeAreRefusedFromTheirHeader) {
  std::vector<std::uint8_t> png = EncodePng(Noise(4, 4, 3));
  // Width and height are big-endian at 16 and 20, the chunk's checksum at 29.
  png[18] = 0x80;
  png[22] = 0x80;
  const auto sum = static_cast<std::uint32_t>(crc32(0, png.data() + 12, 17));
  for (std::size_t i = 0; i < 4; ++i) png[29 + i] = static_cast<std::uint8_t>(sum >> (24 - 8 * i));
  try {
    DecodeImage(png);
    FAIL() << "32772 x 32772 pixels are not refused";
  } catch (const ImageError& e) {
    EXPECT_NE(std::string(e.what()).find("32772 x 32772 pixels; scale it down"), std::string::npos)
        << e.what();
  }
}

TEST(Image, WhatNoFormatHoldsIsRefused) {
  EXPECT_THROW(EncodePng(Image(2, 2, 2)), Error);
  EXPECT_THROW(EncodeJpeg(Image(2, 2, 4), 90), Error);
  EXPECT_THROW(EncodePng16(std::vector<std::uint16_t>(3), 2, 2), Error);
  EXPECT_THROW(Resize(Image(2, 2, 3), 0, 2), Error);
}

}  // namespace
}  // namespace bulletnav::sim
