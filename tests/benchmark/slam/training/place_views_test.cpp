// SPDX-License-Identifier: MIT
#include "benchmark/slam/training/place_views.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmark/slam/training/place_batches.h"
#include "benchmark/slam/training/place_measures.h"
#include "benchmark/slam/training/place_views_file.h"
#include "benchmark/slam/training/vary_pictures.h"
#include "sim/base/error.h"
#include "sim/base/files.h"
#include "tests/benchmark/slam/training/random_views.h"
#include "tests/support/scenes.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;
using tests::RandomViews;

PlaceDataConfig SmallConfig() {
  PlaceDataConfig config;
  config.scenes = {"room.glb"};
  config.camera.rows = 96;
  config.camera.cols = 128;
  config.places = 5;
  config.views = 3;
  return config;
}

const PlaceViews& RoomViews() {
  static const PlaceViews views = [] {
    const auto world = sim::World::FromMesh(tests::BoxRoom(8, 2.6f, 6), "room");
    return MakePlaceViews(*world, nullptr, SmallConfig());
  }();
  return views;
}

TEST(PlaceViews, OfAPlaceShareWhatTheySee) {
  const PlaceViews& views = RoomViews();
  ASSERT_EQ(views.places, 5);
  ASSERT_EQ(views.poses.size(), 15u);
  EXPECT_EQ(views.pictures.size(), 15u * 96 * 128 * 3);
  for (int place = 0; place < 5; ++place) {
    // All of them with the one that the place was chosen by.
    int most = 0;
    for (int a = 3 * place; a < 3 * place + 3; ++a) {
      int shared = 0;
      for (int b = 3 * place; b < 3 * place + 3; ++b) {
        if (views.covisibility(a, b) >= kSamePlace - 0.002) ++shared;
      }
      most = std::max(most, shared);
    }
    EXPECT_EQ(most, 3) << place;
  }
}

TEST(PlaceViews, CovisibilityIsMutualAndSomeViewsAreTurned) {
  const PlaceViews& views = RoomViews();
  int turned = 0;
  for (int a = 0; a < views.count(); ++a) {
    EXPECT_EQ(views.covisibility(a, a), 1.0);
    for (int b = 0; b < a; ++b) {
      EXPECT_EQ(views.covisibility(a, b), views.covisibility(b, a));
      const double turn = std::abs(sim::WrapAngle(views.poses[static_cast<std::size_t>(a)].yaw -
                                                  views.poses[static_cast<std::size_t>(b)].yaw));
      if (a / 3 == b / 3 && turn > M_PI / 2) ++turned;
    }
  }
  EXPECT_GE(turned, 2);
}

TEST(PlaceViews, AreAFunctionOfTheConfig) {
  const auto world = sim::World::FromMesh(tests::BoxRoom(8, 2.6f, 6), "room");
  PlaceDataConfig config = SmallConfig();
  config.places = 2;
  const PlaceViews again = MakePlaceViews(*world, nullptr, config);
  const std::size_t bytes = again.pictures.size();
  EXPECT_TRUE(
      std::equal(again.pictures.begin(), again.pictures.end(), RoomViews().pictures.begin()));
  EXPECT_GT(bytes, 0u);
  config.seed = 7;
  EXPECT_NE(MakePlaceViews(*world, nullptr, config).pictures, again.pictures);
}

TEST(PlaceViewsFile, GivesBackWhatWasKept) {
  const tests::TemporaryFolder folder;
  const auto file = folder.path() / "a.places";
  const PlaceViews views = RandomViews(3, 2, 1);
  WritePlaceViews(file, views, 5);
  const PlaceViews read = ReadPlaceViews(file, 5);
  EXPECT_EQ(read.pictures, views.pictures);
  EXPECT_EQ(read.shared, views.shared);
  EXPECT_EQ(read.views, 2);
  EXPECT_EQ(read.poses[4].position, views.poses[4].position);
  EXPECT_EQ(read.poses[4].yaw, views.poses[4].yaw);
}

TEST(PlaceViewsFile, DamageIsSeen) {
  const tests::TemporaryFolder folder;
  const auto file = folder.path() / "a.places";
  WritePlaceViews(file, RandomViews(2, 2, 1), 5);
  const auto read = [&](std::uint64_t key) {
    return [&file, key] {
      ReadPlaceViews(file, key);
    };
  };
  EXPECT_THAT(read(6), ThrowsMessage<sim::FileError>(HasSubstr("another scene or config")));
  auto bytes = sim::ReadFile(file);
  bytes[bytes.size() / 2] ^= 1;
  sim::WriteFileAtomically(file, bytes);
  EXPECT_THAT(read(5), ThrowsMessage<sim::FileError>(HasSubstr("damaged")));
  bytes.resize(bytes.size() - 3);
  sim::WriteFileAtomically(file, bytes);
  EXPECT_THAT(read(5), ThrowsMessage<sim::FileError>(HasSubstr("size")));
  bytes.resize(20);
  sim::WriteFileAtomically(file, bytes);
  EXPECT_THAT(read(5), ThrowsMessage<sim::FileError>(HasSubstr("ends early")));
}

TEST(PlaceBatches, HoldWholePlacesOfSomeScenes) {
  PlaceBatchSpec spec;
  spec.places = 4;
  spec.scenes = 2;
  spec.rows = 48;
  const PlaceBatches batches({RandomViews(5, 3, 1), RandomViews(4, 3, 2), RandomViews(6, 3, 3)},
                             spec);
  for (std::uint64_t number = 0; number < 10; ++number) {
    const PlaceBatch batch = batches.Batch(number);
    ASSERT_EQ(batch.count, 12);
    EXPECT_EQ(batch.pictures.size(), 12u * 48 * 64 * 3);
    for (std::size_t a = 0; a < 12; ++a) {
      for (std::size_t b = 0; b < 12; ++b) {
        EXPECT_NEAR(batch.covisibility[a * 12 + b], a == b || a / 3 == b / 3 ? 200 / 255.0 : 0.0,
                    1e-6);
      }
    }
    EXPECT_EQ(batches.Batch(number).pictures, batch.pictures);
  }
  EXPECT_NE(batches.Batch(0).pictures, batches.Batch(1).pictures);
  spec.augment = PictureAugmentSpec();
  const PlaceBatches varied({RandomViews(5, 3, 1), RandomViews(4, 3, 2), RandomViews(6, 3, 3)},
                            spec);
  EXPECT_NE(varied.Batch(0).pictures, batches.Batch(0).pictures);
  EXPECT_EQ(varied.Batch(0).pictures, varied.Batch(0).pictures);
  EXPECT_EQ(varied.Batch(0).covisibility, batches.Batch(0).covisibility);
  spec.augment.reset();
  spec.places = 12;
  EXPECT_THROW(PlaceBatches({RandomViews(5, 3, 1), RandomViews(6, 3, 2)}, spec), sim::Error);
  spec.places = 4;
  EXPECT_THROW(PlaceBatches({RandomViews(5, 3, 1)}, spec), sim::Error);
}

PictureAugmentSpec Nothing() {
  return {.mirrored = 0.0, .brightness = 0.0, .contrast = 0.0, .tint = 0.0, .sensor_noise = 0.0};
}

/// Two pictures of 48 x 64 pixels, no two pixels next to each other alike.
std::vector<std::uint8_t> TwoPictures() {
  std::vector<std::uint8_t> pictures(std::size_t{2} * 48 * 64 * 3);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    pictures[i] = static_cast<std::uint8_t>(60 + i % 130);
  }
  return pictures;
}

TEST(VaryPictures, ChangesNothingUnlessAsked) {
  std::vector<std::uint8_t> pictures = TwoPictures();
  VaryPictures(Nothing(), sim::Rng(1, "vary"), 48, &pictures);
  EXPECT_EQ(pictures, TwoPictures());
}

TEST(VaryPictures, MirrorsAllPicturesOrNone) {
  PictureAugmentSpec spec = Nothing();
  spec.mirrored = 1.0;
  const std::vector<std::uint8_t> before = TwoPictures();
  std::vector<std::uint8_t> after = before;
  VaryPictures(spec, sim::Rng(1, "vary"), 48, &after);
  for (std::size_t row = 0; row < std::size_t{2} * 48; ++row) {
    for (std::size_t col = 0; col < 64; ++col) {
      for (std::size_t c = 0; c < 3; ++c) {
        ASSERT_EQ(after[(row * 64 + col) * 3 + c], before[(row * 64 + 63 - col) * 3 + c]);
      }
    }
  }
}

TEST(VaryPictures, EachPictureHasColorsAndNoiseOfItsOwn) {
  PictureAugmentSpec colors = Nothing();
  colors.brightness = 0.3;
  PictureAugmentSpec noise = Nothing();
  noise.sensor_noise = 1.0;
  for (const PictureAugmentSpec& spec : {colors, noise}) {
    std::vector<std::uint8_t> twice(TwoPictures().size(), 128);
    std::vector<std::uint8_t> again = twice;
    VaryPictures(spec, sim::Rng(1, "vary"), 48, &twice);
    VaryPictures(spec, sim::Rng(1, "vary"), 48, &again);
    EXPECT_EQ(twice, again);
    const auto half = static_cast<std::ptrdiff_t>(twice.size() / 2);
    EXPECT_FALSE(std::equal(twice.begin(), twice.begin() + half, twice.begin() + half));
    EXPECT_GT(std::count_if(twice.begin(), twice.end(),
                            [](auto v) {
                              return v != 128;
                            }),
              0);
  }
}

TEST(PictureAugmentSpec, SharesAndSpreadsHaveBounds) {
  EXPECT_NO_THROW(PictureAugmentSpec().Validate());
  PictureAugmentSpec spec;
  spec.mirrored = 1.1;
  EXPECT_THROW(spec.Validate(), sim::Error);
  spec = {};
  spec.tint = 1.0;
  EXPECT_THROW(spec.Validate(), sim::Error);
  spec = {};
  spec.noise_strength = 0.0;
  EXPECT_THROW(spec.Validate(), sim::Error);
}

std::vector<float> CosinesBy(const PlaceViews& views,
                             const std::function<double(int, int)>& cosine) {
  std::vector<float> cosines;
  for (int a = 0; a < views.count(); ++a) {
    for (int b = 0; b < views.count(); ++b) cosines.push_back(static_cast<float>(cosine(a, b)));
  }
  return cosines;
}

TEST(PlaceMeasures, ThePerfectAndTheIgnorant) {
  const PlaceViews views = RandomViews(10, 4, 1);
  const PlaceMeasures perfect = MeasurePlaces(views, CosinesBy(views, [](int a, int b) {
                                                return a / 4 == b / 4 ? 0.9 : 0.1;
                                              }));
  EXPECT_EQ(perfect.ap, 1.0);
  EXPECT_EQ(perfect.recall_at_1, 1.0);
  EXPECT_EQ(perfect.ap_turned, 1.0);
  const PlaceMeasures ignorant = MeasurePlaces(views, CosinesBy(views, [](int, int) {
                                                 return 0.5;
                                               }));
  EXPECT_NEAR(ignorant.ap, ignorant.guessing, 1e-12);
  EXPECT_NEAR(ignorant.guessing, 10 * 6 / (40 * 39 / 2.0), 1e-12);
  const std::vector<PlaceMeasures> both = {perfect, ignorant};
  EXPECT_NEAR(MeanOf(both).ap, (1.0 + ignorant.ap) / 2.0, 1e-12);
}

TEST(PlaceDataConfig, ViewsDependOnAllButTheNamesOfScenes) {
  PlaceDataConfig a = SmallConfig();
  PlaceDataConfig b = a;
  b.scenes = {"other.glb"};
  b.cache = "elsewhere";
  EXPECT_EQ(ViewsKey(a), ViewsKey(b));
  b.camera.cols = 160;
  EXPECT_NE(ViewsKey(a), ViewsKey(b));
}

}  // namespace
}  // namespace bulletnav::bench
