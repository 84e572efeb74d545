// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/gallery.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "sim/base/files.h"
#include "sim/scene/glb_writer.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/training_scenes.h"

namespace bulletnav::bench {
namespace {

DataConfig TwoScenes(const std::filesystem::path& folder) {
  DataConfig config;
  for (const char* name : {"a.glb", "b.glb"}) {
    config.scenes.push_back((folder / name).string());
    sim::WriteFileAtomically(config.scenes.back(), sim::EncodeGlb(tests::TwoRooms()));
  }
  config.panorama.cols = 64;
  config.panorama.rows = 32;
  return config;
}

TEST(Gallery, HasAPanoramaBelowTheOther) {
  const tests::TemporaryFolder folder;
  const DataConfig config = TwoScenes(folder.path());
  int drawn = 0;
  const sim::Image sheet = DrawGallery(config, 5, [&] {
    ++drawn;
  });
  EXPECT_EQ(drawn, 5);
  EXPECT_EQ(sheet.width, 64);
  EXPECT_EQ(sheet.height, 5 * 32 + 4 * 4);
  const std::size_t row = 3 * 64;
  for (int gap = 0; gap < 4; ++gap) {
    const std::uint8_t* first = sheet.at(0, 36 * gap + 32);
    EXPECT_TRUE(std::all_of(first, first + 4 * row, [](std::uint8_t v) {
      return v == 255;
    }));
  }
  EXPECT_EQ(sheet.pixels, DrawGallery(config, 5, [] {}).pixels);
}

TEST(Gallery, ShowsScenesInTheirLooks) {
  const tests::TemporaryFolder folder;
  DataConfig config = TwoScenes(folder.path());
  const sim::Image plain = DrawGallery(config, 2, [] {});
  config.looks = LooksSpec{.share = 1.0};
  EXPECT_NE(DrawGallery(config, 2, [] {}).pixels, plain.pixels);
}

}  // namespace
}  // namespace bulletnav::bench
