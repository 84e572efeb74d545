// SPDX-License-Identifier: MIT
#include "sim/house/materials.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <set>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/error.h"

namespace bulletnav::sim {
namespace {

using ::testing::HasSubstr;

/// Mean colour of a picture.
std::array<double, 3> Mean(const Image& image) {
  std::array<double, 3> sum{};
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      for (std::size_t c = 0; c < 3; ++c) sum[c] += image.at(x, y)[c];
    }
  }
  for (double& s : sum) s /= static_cast<double>(image.width) * image.height;
  return sum;
}

/// Mean difference between column `x` and the next, the first being next to the last.
double Step(const Image& image, int x) {
  double sum = 0.0;
  for (int y = 0; y < image.height; ++y) {
    const std::uint8_t* here = image.at(x, y);
    const std::uint8_t* next = image.at((x + 1) % image.width, y);
    for (int c = 0; c < 3; ++c) sum += std::abs(int{here[c]} - int{next[c]});
  }
  return sum / (3.0 * image.height);
}

/// Rows and columns exchanged.
Image Transposed(const Image& image) {
  Image turned(image.height, image.width, image.channels);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      std::copy_n(image.at(x, y), image.channels, turned.at(y, x));
    }
  }
  return turned;
}

/// The step over the left and right edges is none that the inside does not have as well.
bool WrapsAcross(const Image& image) {
  double largest = 0.0;
  for (int x = 0; x + 1 < image.width; ++x) largest = std::max(largest, Step(image, x));
  return Step(image, image.width - 1) <= 1.05 * largest + 0.5;
}

/// How unlike two pictures are from afar: the root mean square difference of their thumbnails,
/// which includes that of their mean colours.
double Unlikeness(const Image& a, const Image& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const double d = static_cast<double>(a.pixels[i]) - static_cast<double>(b.pixels[i]);
    sum += d * d;
  }
  // A quarter of the values is alpha, the same everywhere.
  return std::sqrt(sum / (0.75 * static_cast<double>(a.pixels.size())));
}

TEST(MaterialsTest, NamesAreUniqueAndSorted) {
  const auto all = AllMaterials();
  EXPECT_GE(all.size(), 60u);
  for (std::size_t i = 1; i < all.size(); ++i) EXPECT_LT(all[i - 1].name, all[i].name);
}

TEST(MaterialsTest, SizesAreThoseOfSurfaces) {
  for (const MaterialRecipe& recipe : AllMaterials()) {
    EXPECT_GE(recipe.metres, 0.2f) << recipe.name;
    EXPECT_LE(recipe.metres, 2.5f) << recipe.name;
  }
}

TEST(MaterialsTest, EveryFamilyHasSome) {
  std::set<MaterialFamily> families;
  for (const MaterialRecipe& recipe : AllMaterials()) families.insert(recipe.family);
  EXPECT_EQ(families.size(), 10u);
}

TEST(MaterialsTest, FindsEveryMaterialByItsName) {
  for (const MaterialRecipe& recipe : AllMaterials()) {
    EXPECT_EQ(&FindMaterial(recipe.name), &recipe);
  }
}

TEST(MaterialsTest, UnknownNameGetsTheNearestKnownOne) {
  try {
    FindMaterial("oak_plank");
    FAIL() << "found a material that does not exist";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("'oak_plank'"));
    EXPECT_THAT(error.what(), HasSubstr("'oak_planks'"));
  }
}

TEST(MaterialsTest, CacheKeepsWhatItDrew) {
  TextureCache cache;
  const Image& first = cache.Get("paper");
  cache.Get("ceramic");
  EXPECT_EQ(&cache.Get("paper"), &first);
  EXPECT_EQ(first.pixels, FindMaterial("paper").draw().pixels);
  EXPECT_THROW(cache.Get("unobtainium"), Error);
}

TEST(MaterialsTest, NoTwoLookAlike) {
  constexpr double kLeast = 2.0;
  const auto all = AllMaterials();
  std::vector<Image> thumbnails;
  for (const MaterialRecipe& recipe : all) thumbnails.push_back(Resize(recipe.draw(), 8, 8));
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_GT(Unlikeness(thumbnails[i], thumbnails[j]), kLeast)
          << all[i].name << " and " << all[j].name;
    }
  }
}

TEST(MaterialsTest, TintableOnesAreLightAndNeutral) {
  for (const char* name : {"beadboard",
                           "canvas",
                           "ceramic",
                           "checked_bedding",
                           "damask_wallpaper",
                           "dotted_fabric",
                           "floral_fabric",
                           "floral_wallpaper",
                           "geometric_wallpaper",
                           "lamp_shade",
                           "leaf_wallpaper",
                           "leather",
                           "linen",
                           "loop_carpet",
                           "painted_wood",
                           "paper",
                           "plaid",
                           "plaster_rough",
                           "plaster_smooth",
                           "plastic",
                           "plush_carpet",
                           "polka_wallpaper",
                           "quilt",
                           "rubber",
                           "shag_carpet",
                           "stars_wallpaper",
                           "striped_cotton",
                           "striped_rug",
                           "striped_wallpaper",
                           "terry_towel",
                           "tweed",
                           "velvet",
                           "wainscot",
                           "white_enamel",
                           "wool_knit"}) {
    const auto mean = Mean(FindMaterial(name).draw());
    EXPECT_GE(*std::min_element(mean.begin(), mean.end()), 185.0) << name;
    EXPECT_LE(*std::max_element(mean.begin(), mean.end()), 252.0) << name;
    EXPECT_LE(
        *std::max_element(mean.begin(), mean.end()) - *std::min_element(mean.begin(), mean.end()),
        20.0)
        << name;
  }
}

TEST(MaterialsTest, DaylightAndDarknessAreWhereTheyBelong) {
  for (const char* view : {"city_view", "garden_view", "hills_view", "street_view"}) {
    EXPECT_GT(Mean(FindMaterial(view).draw())[1], 180.0) << view;
  }
  EXPECT_LT(Mean(FindMaterial("tv_screen").draw())[1], 60.0);
}

TEST(MaterialsTest, SeamsAreNoticed) {
  Image ramp(64, 64, 4);
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      for (int c = 0; c < 3; ++c) ramp.at(x, y)[c] = static_cast<std::uint8_t>(2 * x);
    }
  }
  EXPECT_FALSE(WrapsAcross(ramp));
  EXPECT_TRUE(WrapsAcross(Transposed(ramp)));
}

/// Properties of single pictures, tested a family at a time to keep tests short.
class MaterialPictures : public ::testing::TestWithParam<MaterialFamily> {
 protected:
  template <class F>
  void ForEach(const F& check) {
    for (const MaterialRecipe& recipe : AllMaterials()) {
      if (recipe.family == GetParam()) check(recipe);
    }
  }
};

TEST_P(MaterialPictures, AreSquareAndOpaqueAndNotFlat) {
  ForEach([](const MaterialRecipe& recipe) {
    const Image image = recipe.draw();
    EXPECT_EQ(image.channels, 4) << recipe.name;
    EXPECT_EQ(image.width, image.height) << recipe.name;
    EXPECT_TRUE(std::has_single_bit(static_cast<unsigned>(image.width))) << recipe.name;
    EXPECT_GE(image.width, 128) << recipe.name;
    std::set<int> greens;
    bool opaque = true;
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
      greens.insert(image.pixels[i + 1]);
      opaque = opaque && image.pixels[i + 3] == 255;
    }
    EXPECT_TRUE(opaque) << recipe.name;
    EXPECT_GE(greens.size(), 4u) << recipe.name;
  });
}

TEST_P(MaterialPictures, WrapUnlessShownOnce) {
  ForEach([](const MaterialRecipe& recipe) {
    if (!recipe.wraps) return;
    const Image image = recipe.draw();
    EXPECT_TRUE(WrapsAcross(image)) << recipe.name << ", left and right";
    EXPECT_TRUE(WrapsAcross(Transposed(image))) << recipe.name << ", top and bottom";
  });
}

TEST_P(MaterialPictures, AreTheSameEveryTime) {
  ForEach([](const MaterialRecipe& recipe) {
    EXPECT_EQ(recipe.draw().pixels, recipe.draw().pixels) << recipe.name;
  });
}

INSTANTIATE_TEST_SUITE_P(Families, MaterialPictures,
                         ::testing::Values(MaterialFamily::kWood, MaterialFamily::kTile,
                                           MaterialFamily::kStone, MaterialFamily::kBrick,
                                           MaterialFamily::kCarpet, MaterialFamily::kFabric,
                                           MaterialFamily::kPaint, MaterialFamily::kWallpaper,
                                           MaterialFamily::kMetal, MaterialFamily::kOther));

}  // namespace
}  // namespace bulletnav::sim
