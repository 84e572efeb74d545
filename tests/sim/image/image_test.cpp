// SPDX-License-Identifier: MIT
#include "sim/image/image.h"

#include <cstdlib>

#include <gtest/gtest.h>

#include "sim/base/error.h"
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

TEST(Image, WhatNoFormatHoldsIsRefused) {
  EXPECT_THROW(EncodePng(Image(2, 2, 2)), Error);
  EXPECT_THROW(EncodeJpeg(Image(2, 2, 4), 90), Error);
  EXPECT_THROW(EncodePng16(std::vector<std::uint16_t>(3), 2, 2), Error);
  EXPECT_THROW(Resize(Image(2, 2, 3), 0, 2), Error);
}

}  // namespace
}  // namespace bulletnav::sim
