// SPDX-License-Identifier: MIT
#include "sim/house/materials.h"

#include <algorithm>
#include <array>
#include <vector>

#include "sim/base/error.h"
#include "sim/config/yaml_reader.h"

namespace bulletnav::sim {
namespace {

Image Flat() {
  Image image(4, 4, 4);
  std::fill(image.pixels.begin(), image.pixels.end(), std::uint8_t{200});
  return image;
}

constexpr std::array kRecipes = {
    MaterialRecipe{"bamboo", MaterialFamily::kWood, 0.8f, Flat},
    MaterialRecipe{"beadboard", MaterialFamily::kPaint, 0.4f, Flat},
    MaterialRecipe{"beech", MaterialFamily::kWood, 1.0f, Flat},
    MaterialRecipe{"beige_stone_tile", MaterialFamily::kTile, 1.6f, Flat},
    MaterialRecipe{"berber_carpet", MaterialFamily::kCarpet, 0.6f, Flat},
    MaterialRecipe{"black_marble", MaterialFamily::kStone, 1.6f, Flat},
    MaterialRecipe{"black_metal", MaterialFamily::kMetal, 0.6f, Flat},
    MaterialRecipe{"black_tile", MaterialFamily::kTile, 0.8f, Flat},
    MaterialRecipe{"blackboard", MaterialFamily::kOther, 1.0f, Flat},
    MaterialRecipe{"blue_mosaic", MaterialFamily::kTile, 0.6f, Flat},
    MaterialRecipe{"book_spines", MaterialFamily::kOther, 1.0f, Flat},
    MaterialRecipe{"book_spines_dark", MaterialFamily::kOther, 1.0f, Flat},
    MaterialRecipe{"bottles", MaterialFamily::kOther, 1.0f, Flat},
    MaterialRecipe{"brass", MaterialFamily::kMetal, 0.6f, Flat},
    MaterialRecipe{"brown_brick", MaterialFamily::kBrick, 1.2f, Flat},
    MaterialRecipe{"brown_granite", MaterialFamily::kStone, 0.8f, Flat},
    MaterialRecipe{"brushed_steel", MaterialFamily::kMetal, 0.6f, Flat},
    MaterialRecipe{"canvas", MaterialFamily::kFabric, 0.5f, Flat},
    MaterialRecipe{"cardboard", MaterialFamily::kOther, 0.6f, Flat},
    MaterialRecipe{"cast_iron", MaterialFamily::kMetal, 0.6f, Flat},
    MaterialRecipe{"cement_pattern_tile", MaterialFamily::kTile, 0.8f, Flat},
    MaterialRecipe{"ceramic", MaterialFamily::kOther, 0.6f, Flat},
    MaterialRecipe{"checked_bedding", MaterialFamily::kFabric, 0.5f, Flat},
    MaterialRecipe{"checker_tile", MaterialFamily::kTile, 1.2f, Flat},
    MaterialRecipe{"chrome", MaterialFamily::kMetal, 0.6f, Flat},
    MaterialRecipe{"city_view", MaterialFamily::kOther, 1.0f, Flat},
    MaterialRecipe{"clock_face", MaterialFamily::kOther, 1.0f, Flat},
    MaterialRecipe{"clothes", MaterialFamily::kOther, 1.0f, Flat},
    MaterialRecipe{"computer_screen", MaterialFamily::kOther, 1.0f, Flat},
    MaterialRecipe{"concrete", MaterialFamily::kStone, 2.0f, Flat},
    MaterialRecipe{"copper", MaterialFamily::kMetal, 0.6f, Flat},
    MaterialRecipe{"cork", MaterialFamily::kOther, 0.6f, Flat},
    MaterialRecipe{"damask_wallpaper", MaterialFamily::kWallpaper, 0.8f, Flat},
    MaterialRecipe{"dotted_fabric", MaterialFamily::kFabric, 0.4f, Flat},
    MaterialRecipe{"family_photos", MaterialFamily::kOther, 1.0f, Flat},
    MaterialRecipe{"floral_fabric", MaterialFamily::kFabric, 0.6f, Flat},
    MaterialRecipe{"floral_wallpaper", MaterialFamily::kWallpaper, 0.8f, Flat},
    MaterialRecipe{"food_boxes", MaterialFamily::kOther, 1.0f, Flat},
    MaterialRecipe{"garden_view", MaterialFamily::kOther, 1.0f, Flat},
    MaterialRecipe{"geometric_rug", MaterialFamily::kCarpet, 1.2f, Flat},
    MaterialRecipe{"geometric_wallpaper", MaterialFamily::kWallpaper, 0.8f, Flat},
    MaterialRecipe{"glass", MaterialFamily::kOther, 1.0f, Flat},
    MaterialRecipe{"grasscloth_wallpaper", MaterialFamily::kWallpaper, 0.8f, Flat},
    MaterialRecipe{"green_subway_tile", MaterialFamily::kTile, 0.8f, Flat},
    MaterialRecipe{"grey_granite", MaterialFamily::kStone, 0.8f, Flat},
    MaterialRecipe{"grey_large_tile", MaterialFamily::kTile, 1.8f, Flat},
    MaterialRecipe{"grey_planks", MaterialFamily::kWood, 1.8f, Flat},
    MaterialRecipe{"hills_view", MaterialFamily::kOther, 1.0f, Flat},
    MaterialRecipe{"jute_rug", MaterialFamily::kCarpet, 0.6f, Flat},
    MaterialRecipe{"keyboard", MaterialFamily::kOther, 1.0f, Flat},
    MaterialRecipe{"kids_rug", MaterialFamily::kCarpet, 1.6f, Flat},
    MaterialRecipe{"lamp_shade", MaterialFamily::kOther, 0.6f, Flat},
    MaterialRecipe{"leaf_wallpaper", MaterialFamily::kWallpaper, 1.0f, Flat},
    MaterialRecipe{"leather", MaterialFamily::kFabric, 0.8f, Flat},
    MaterialRecipe{"leaves", MaterialFamily::kOther, 0.4f, Flat},
    MaterialRecipe{"limestone", MaterialFamily::kStone, 1.6f, Flat},
    MaterialRecipe{"linen", MaterialFamily::kFabric, 0.5f, Flat},
    MaterialRecipe{"loop_carpet", MaterialFamily::kCarpet, 0.6f, Flat},
    MaterialRecipe{"mahogany", MaterialFamily::kWood, 1.0f, Flat},
    MaterialRecipe{"mirror", MaterialFamily::kOther, 1.0f, Flat},
    MaterialRecipe{"oak", MaterialFamily::kWood, 1.0f, Flat},
    MaterialRecipe{"oak_herringbone", MaterialFamily::kWood, 1.2f, Flat},
    MaterialRecipe{"oak_planks", MaterialFamily::kWood, 1.8f, Flat},
    MaterialRecipe{"oven_front", MaterialFamily::kOther, 1.0f, Flat},
    MaterialRecipe{"painted_wood", MaterialFamily::kWood, 1.0f, Flat},
    MaterialRecipe{"painting_abstract", MaterialFamily::kOther, 1.0f, Flat},
    MaterialRecipe{"painting_flowers", MaterialFamily::kOther, 1.0f, Flat},
    MaterialRecipe{"painting_geometric", MaterialFamily::kOther, 1.0f, Flat},
    MaterialRecipe{"painting_landscape", MaterialFamily::kOther, 1.0f, Flat},
    MaterialRecipe{"painting_portrait", MaterialFamily::kOther, 1.0f, Flat},
    MaterialRecipe{"painting_sea", MaterialFamily::kOther, 1.0f, Flat},
    MaterialRecipe{"paper", MaterialFamily::kOther, 0.6f, Flat},
    MaterialRecipe{"penny_tile", MaterialFamily::kTile, 0.4f, Flat},
    MaterialRecipe{"persian_rug", MaterialFamily::kCarpet, 2.0f, Flat},
    MaterialRecipe{"pine", MaterialFamily::kWood, 1.0f, Flat},
    MaterialRecipe{"pine_planks", MaterialFamily::kWood, 1.8f, Flat},
    MaterialRecipe{"plaid", MaterialFamily::kFabric, 0.6f, Flat},
    MaterialRecipe{"plaster_rough", MaterialFamily::kPaint, 2.0f, Flat},
    MaterialRecipe{"plaster_smooth", MaterialFamily::kPaint, 2.0f, Flat},
    MaterialRecipe{"plastic", MaterialFamily::kOther, 0.6f, Flat},
    MaterialRecipe{"plush_carpet", MaterialFamily::kCarpet, 0.8f, Flat},
    MaterialRecipe{"polka_wallpaper", MaterialFamily::kWallpaper, 0.6f, Flat},
    MaterialRecipe{"poster_animals", MaterialFamily::kOther, 1.0f, Flat},
    MaterialRecipe{"poster_space", MaterialFamily::kOther, 1.0f, Flat},
    MaterialRecipe{"quilt", MaterialFamily::kFabric, 0.6f, Flat},
    MaterialRecipe{"rattan", MaterialFamily::kWood, 0.4f, Flat},
    MaterialRecipe{"red_brick", MaterialFamily::kBrick, 1.2f, Flat},
    MaterialRecipe{"rubber", MaterialFamily::kOther, 0.6f, Flat},
    MaterialRecipe{"shag_carpet", MaterialFamily::kCarpet, 0.8f, Flat},
    MaterialRecipe{"slate_tile", MaterialFamily::kTile, 1.6f, Flat},
    MaterialRecipe{"soil", MaterialFamily::kOther, 0.4f, Flat},
    MaterialRecipe{"stars_wallpaper", MaterialFamily::kWallpaper, 1.0f, Flat},
    MaterialRecipe{"stone_wall", MaterialFamily::kStone, 1.6f, Flat},
    MaterialRecipe{"street_view", MaterialFamily::kOther, 1.0f, Flat},
    MaterialRecipe{"striped_cotton", MaterialFamily::kFabric, 0.5f, Flat},
    MaterialRecipe{"striped_rug", MaterialFamily::kCarpet, 1.2f, Flat},
    MaterialRecipe{"striped_wallpaper", MaterialFamily::kWallpaper, 0.6f, Flat},
    MaterialRecipe{"terracotta_tile", MaterialFamily::kTile, 1.2f, Flat},
    MaterialRecipe{"terrazzo", MaterialFamily::kStone, 1.0f, Flat},
    MaterialRecipe{"terry_towel", MaterialFamily::kFabric, 0.4f, Flat},
    MaterialRecipe{"toys", MaterialFamily::kOther, 1.0f, Flat},
    MaterialRecipe{"tv_screen", MaterialFamily::kOther, 1.0f, Flat},
    MaterialRecipe{"tweed", MaterialFamily::kFabric, 0.4f, Flat},
    MaterialRecipe{"velvet", MaterialFamily::kFabric, 0.6f, Flat},
    MaterialRecipe{"wainscot", MaterialFamily::kPaint, 0.8f, Flat},
    MaterialRecipe{"walnut", MaterialFamily::kWood, 1.0f, Flat},
    MaterialRecipe{"walnut_parquet", MaterialFamily::kWood, 1.2f, Flat},
    MaterialRecipe{"walnut_planks", MaterialFamily::kWood, 1.8f, Flat},
    MaterialRecipe{"weathered_wood", MaterialFamily::kWood, 1.2f, Flat},
    MaterialRecipe{"wenge", MaterialFamily::kWood, 1.0f, Flat},
    MaterialRecipe{"white_brick", MaterialFamily::kBrick, 1.2f, Flat},
    MaterialRecipe{"white_enamel", MaterialFamily::kMetal, 0.8f, Flat},
    MaterialRecipe{"white_hex_tile", MaterialFamily::kTile, 0.6f, Flat},
    MaterialRecipe{"white_marble", MaterialFamily::kStone, 1.6f, Flat},
    MaterialRecipe{"white_square_tile", MaterialFamily::kTile, 0.8f, Flat},
    MaterialRecipe{"white_subway_tile", MaterialFamily::kTile, 0.8f, Flat},
    MaterialRecipe{"wicker", MaterialFamily::kOther, 0.3f, Flat},
    MaterialRecipe{"wool_knit", MaterialFamily::kFabric, 0.4f, Flat},
    MaterialRecipe{"world_map", MaterialFamily::kOther, 1.0f, Flat},
};

}  // namespace

std::span<const MaterialRecipe> AllMaterials() {
  return kRecipes;
}

const MaterialRecipe& FindMaterial(std::string_view name) {
  const auto all = AllMaterials();
  const auto found =
      std::lower_bound(all.begin(), all.end(), name, [](const MaterialRecipe& r, auto n) {
        return r.name < n;
      });
  if (found != all.end() && found->name == name) return *found;
  std::vector<std::string> names;
  for (const MaterialRecipe& r : all) names.emplace_back(r.name);
  throw Error("no material '" + std::string(name) + "'; did you mean '" + NearestWord(name, names) +
              "'?");
}

const Image& TextureCache::Get(std::string_view material) {
  const auto found = images_.find(material);
  if (found != images_.end()) return found->second;
  return images_.emplace(material, FindMaterial(material).draw()).first->second;
}

}  // namespace bulletnav::sim
