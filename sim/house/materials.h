// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <span>
#include <string>
#include <string_view>

#include "sim/image/image.h"
#include "sim/scene/mesh.h"

namespace bulletnav::sim {

enum class MaterialFamily {
  kWood,
  kTile,
  kStone,
  kBrick,
  kCarpet,
  kFabric,
  kPaint,
  kWallpaper,
  kMetal,
  kOther
};

/// One procedural surface. `draw` makes a square, opaque RGBA picture whose side is a power of two.
/// It covers `metres` x `metres` and wraps around in both directions, or is a picture to be shown
/// once, stretched over its face. It depends on nothing but the recipe, so every house that uses a
/// material shows the same one. Colour variety within a recipe comes from tints. The grain of woods
/// runs down the picture, boards and planks of floors run across it.
struct MaterialRecipe {
  std::string_view name;  // "oak_planks"
  MaterialFamily family = MaterialFamily::kOther;
  float metres = 1.0f;
  Image (*draw)() = nullptr;
  bool wraps = true;  // false: a picture, shown once
};

/// Every recipe, sorted by name; at least 60.
std::span<const MaterialRecipe> AllMaterials();

/// Throws Error, naming the nearest known name, if there is no such material.
const MaterialRecipe& FindMaterial(std::string_view name);

/// A recipe in a colour: what a surface of a house is made of.
struct Surface {
  std::string_view material;
  Rgb8 tint = kWhite;
};

/// Pictures already drawn. Drawing takes milliseconds and houses share materials.
class TextureCache {
 public:
  const Image& Get(std::string_view material);

 private:
  std::map<std::string, Image, std::less<>> images_;
};

}  // namespace bulletnav::sim
