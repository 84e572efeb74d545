// SPDX-License-Identifier: MIT
#include "sim/scene/mesh.h"

#include <functional>
#include <limits>

#include <gmock/gmock.h>

#include "sim/base/error.h"
#include "tests/support/scenes.h"

namespace bulletnav::sim {
namespace {

using testing::HasSubstr;

std::string ComplaintAfter(const std::function<void(SceneMesh*)>& spoil) {
  SceneMesh mesh = tests::BoxRoom(4, 2.5f, 3);
  mesh.textures.push_back({"wall", Image(2, 2, 4)});
  spoil(&mesh);
  try {
    mesh.Validate();
  } catch (const Error& e) {
    return e.what();
  }
  return "nothing";
}

TEST(SceneMesh, AWholeOneIsValid) {
  EXPECT_EQ(ComplaintAfter([](SceneMesh*) {}), "nothing");
}

TEST(SceneMesh, NamesWhatDoesNotFit) {
  constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const std::pair<std::function<void(SceneMesh*)>, const char*> cases[] = {
      {[](SceneMesh* m) {
         *m = {};
       },
       "no triangles"},
      {[](SceneMesh* m) {
         m->uvs.clear();
       },
       "0 uvs"},
      {[](SceneMesh* m) {
         m->colors.pop_back();
       },
       "colors"},
      {[](SceneMesh* m) {
         m->triangle_materials.pop_back();
       },
       "triangle_materials"},
      {[](SceneMesh* m) {
         m->materials.clear();
       },
       "material 0 of 0"},
      {[](SceneMesh* m) {
         m->triangles[3][1] = 4'000'000'000u;
       },
       "triangle 3 names vertex 4000000000"},
      {[](SceneMesh* m) {
         m->triangle_materials[2] = 77;
       },
       "triangle 2 names material 77"},
      {[](SceneMesh* m) {
         m->materials[0].texture = 1;
       },
       "texture 1 of 1"},
      {[](SceneMesh* m) {
         m->materials[0].texture = -7;
       },
       "texture -7"},
      {[=](SceneMesh* m) {
         m->positions[5].y() = kNaN;
       },
       "vertex 5 is not finite"},
      {[=](SceneMesh* m) {
         m->uvs[6].x() = kInfinity;
       },
       "vertex 6 is not finite"},
      {[](SceneMesh* m) {
         m->textures[0].image = {};
       },
       "'wall'"},
      {[](SceneMesh* m) {
         m->textures[0].image = Image(2, 2, 3);
       },
       "no RGBA"}};
  for (const auto& [spoil, complaint] : cases) {
    EXPECT_THAT(ComplaintAfter(spoil), HasSubstr(complaint));
  }
}

}  // namespace
}  // namespace bulletnav::sim
