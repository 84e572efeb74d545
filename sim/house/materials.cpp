// SPDX-License-Identifier: MIT
#include "sim/house/materials.h"

#include <algorithm>
#include <vector>

#include "sim/base/error.h"
#include "sim/config/yaml_reader.h"
#include "sim/house/materials/families.h"

namespace bulletnav::sim {
namespace {

std::vector<MaterialRecipe> Joined() {
  std::vector<MaterialRecipe> all;
  for (const auto family :
       {materials::BookShelves, materials::Brickwork, materials::Carpets,
        materials::Fabrics,     materials::Maps,      materials::Metals,
        materials::Paintings,   materials::Paints,    materials::PatternedFabrics,
        materials::PersianRugs, materials::Plains,    materials::PlayMats,
        materials::Posters,     materials::Rugs,      materials::Screens,
        materials::Shelves,     materials::Stones,    materials::Tiles,
        materials::Toys,        materials::Views,     materials::Wallpapers,
        materials::WoodFloors,  materials::Woods,     materials::Fitouts}) {
    const auto recipes = family();
    all.insert(all.end(), recipes.begin(), recipes.end());
  }
  std::sort(all.begin(), all.end(), [](const MaterialRecipe& a, const MaterialRecipe& b) {
    return a.name < b.name;
  });
  return all;
}

}  // namespace

std::span<const MaterialRecipe> AllMaterials() {
  static const std::vector<MaterialRecipe> all = Joined();
  return all;
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
