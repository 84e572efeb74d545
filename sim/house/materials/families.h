// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "sim/house/materials.h"

namespace bulletnav::sim::materials {

// The recipes of each file of this folder, in any order; AllMaterials joins and sorts them.
std::span<const MaterialRecipe> BookShelves();
std::span<const MaterialRecipe> Brickwork();
std::span<const MaterialRecipe> Carpets();
std::span<const MaterialRecipe> Fabrics();
std::span<const MaterialRecipe> Fitouts();
std::span<const MaterialRecipe> Maps();
std::span<const MaterialRecipe> Metals();
std::span<const MaterialRecipe> Toys();
std::span<const MaterialRecipe> Paintings();
std::span<const MaterialRecipe> Paints();
std::span<const MaterialRecipe> PatternedFabrics();
std::span<const MaterialRecipe> PersianRugs();
std::span<const MaterialRecipe> Plains();
std::span<const MaterialRecipe> PlayMats();
std::span<const MaterialRecipe> Posters();
std::span<const MaterialRecipe> Rugs();
std::span<const MaterialRecipe> Screens();
std::span<const MaterialRecipe> Shelves();
std::span<const MaterialRecipe> Stones();
std::span<const MaterialRecipe> Tiles();
std::span<const MaterialRecipe> Views();
std::span<const MaterialRecipe> Wallpapers();
std::span<const MaterialRecipe> WoodFloors();
std::span<const MaterialRecipe> Woods();

}  // namespace bulletnav::sim::materials
