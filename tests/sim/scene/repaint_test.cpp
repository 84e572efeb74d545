// SPDX-License-Identifier: MIT
#include "sim/scene/repaint.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "sim/base/error.h"

namespace bulletnav::sim {
namespace {

/// One triangle a material; `textures` of them have a texture of two greys, the rest a colour.
SceneMesh Patches(int textures, int plain) {
  SceneMesh mesh;
  for (int i = 0; i < textures + plain; ++i) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const float x : {0.0f, 1.0f, 2.0f}) {
      mesh.positions.emplace_back(x, static_cast<float>(i), x * x);
      mesh.uvs.emplace_back(x, 0);
      mesh.colors.push_back({90, 100, 110});
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangle_materials.push_back(static_cast<std::uint32_t>(i));
    mesh.materials.push_back({"m", {120, 130, 140}, i < textures ? i : -1});
  }
  for (int i = 0; i < textures; ++i) {
    Image picture(2, 1, 4);
    picture.pixels = {60, 60, 60, 255, 100, 100, 100, 200};
    mesh.textures.push_back({"t", picture});
  }
  mesh.Validate();
  return mesh;
}

bool IsSame(const SceneMesh& a, const SceneMesh& b) {
  const auto same_material = [](const Material& x, const Material& y) {
    return x.base_color == y.base_color && x.texture == y.texture;
  };
  const auto same_texture = [](const Texture& x, const Texture& y) {
    return x.image.pixels == y.image.pixels;
  };
  return std::equal(a.materials.begin(), a.materials.end(), b.materials.begin(), same_material) &&
         std::equal(a.textures.begin(), a.textures.end(), b.textures.begin(), same_texture) &&
         a.colors == b.colors;
}

TEST(Repaint, NoShareChangesNothingAndTheSameSeedTheSame) {
  const Rng rng(3, "paint");
  SceneMesh mesh = Patches(4, 4);
  RecolorMaterials(0.0, rng, &mesh);
  ExchangeTextures(0.0, rng, &mesh);
  EXPECT_TRUE(IsSame(mesh, Patches(4, 4)));
  SceneMesh again = Patches(4, 4);
  for (SceneMesh* one : {&mesh, &again}) {
    RecolorMaterials(0.7, rng, one);
    ExchangeTextures(0.7, rng, one);
    one->Validate();
  }
  EXPECT_TRUE(IsSame(mesh, again));
  EXPECT_FALSE(IsSame(mesh, Patches(4, 4)));
}

TEST(Repaint, TheShareOfMaterialsIsWhatWasAsked) {
  SceneMesh mesh = Patches(300, 300);
  RecolorMaterials(0.4, Rng(1, "paint"), &mesh);
  int textures = 0;
  int colors = 0;
  for (std::size_t i = 0; i < 300; ++i) {
    textures += mesh.textures[i].image.pixels[0] != 60 || mesh.textures[i].image.pixels[1] != 60;
    colors += mesh.materials[300 + i].base_color != Rgb8{120, 130, 140};
    // A texture's material keeps its factor, else it would be painted twice.
    EXPECT_EQ(mesh.materials[i].base_color, (Rgb8{120, 130, 140}));
  }
  EXPECT_NEAR(textures / 300.0, 0.4, 0.08);
  EXPECT_NEAR(colors / 300.0, 0.4, 0.08);
}

TEST(Repaint, LightAndDarkStayAndSoDoesTransparency) {
  SceneMesh mesh = Patches(200, 0);
  RecolorMaterials(1.0, Rng(2, "paint"), &mesh);
  std::set<int> hues;
  for (const Texture& texture : mesh.textures) {
    const auto& p = texture.image.pixels;
    for (std::size_t c = 0; c < 3; ++c) EXPECT_LE(p[c], p[4 + c]);
    EXPECT_EQ(p[3], 255);
    EXPECT_EQ(p[7], 200);
    // Which channel is the strongest.
    hues.insert(static_cast<int>(std::max_element(p.begin(), p.begin() + 3) - p.begin()));
  }
  EXPECT_EQ(hues.size(), 3u);
}

TEST(Repaint, ExchangedTexturesAreAllStillThere) {
  SceneMesh mesh = Patches(50, 10);
  ExchangeTextures(1.0, Rng(5, "paint"), &mesh);
  mesh.Validate();
  std::multiset<int> used;
  int moved = 0;
  for (std::size_t i = 0; i < mesh.materials.size(); ++i) {
    used.insert(mesh.materials[i].texture);
    moved += i < 50 && mesh.materials[i].texture != static_cast<int>(i);
  }
  EXPECT_EQ(used.count(-1), 10u);
  for (int i = 0; i < 50; ++i) EXPECT_EQ(used.count(i), 1u);
  EXPECT_GT(moved, 40);
}

TEST(Repaint, RefusesWhatIsNoShare) {
  EXPECT_THROW(Repaint{.recolored = 1.2}.Validate(), Error);
  EXPECT_THROW(Repaint{.exchanged = -0.1}.Validate(), Error);
  SceneMesh mesh = Patches(4, 4);
  ApplyRepaint({}, &mesh);
  EXPECT_TRUE(IsSame(mesh, Patches(4, 4)));
}

}  // namespace
}  // namespace bulletnav::sim
