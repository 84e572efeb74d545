// SPDX-License-Identifier: MIT
// What is seen of a scene's objects, against rays.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "sim/render/cpu/cpu_scene.h"
#include "sim/render/egl/egl_scene.h"
#include "tests/support/scenes.h"
#include "tests/support/seen_triangles.h"

namespace bulletnav::sim {
namespace {

constexpr Rgb8 kGrey = {128, 128, 128};

/// A room without a ceiling, with three boxes in it; the walls are one object, each box another,
/// the floor is none.
SceneMesh Room() {
  SceneMesh mesh = tests::BoxRoom(4, 2.6f, 6);
  std::vector<std::array<std::uint32_t, 3>> kept;
  std::vector<std::uint32_t> materials;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto height = [&](int k) {
      return mesh.positions[mesh.triangles[t][k]].y();
    };
    if (std::min({height(0), height(1), height(2)}) > 2.0f) continue;
    kept.push_back(mesh.triangles[t]);
    materials.push_back(mesh.triangle_materials[t]);
    const bool is_floor = std::max({height(0), height(1), height(2)}) < 0.1f;
    mesh.triangle_objects.push_back(is_floor ? 0 : 1);
  }
  mesh.triangles = kept;
  mesh.triangle_materials = materials;
  mesh.objects = {{}, {"wall", "wall_1", "room"}};
  for (int i = 0; i < 3; ++i) {
    const float x = 0.5f + static_cast<float>(i);
    tests::AddBox({x, 0, -5}, {x + 0.6f, 0.5f + 0.6f * static_cast<float>(i), -4}, kGrey, &mesh);
    mesh.triangle_objects.resize(mesh.triangles.size(), static_cast<std::uint32_t>(i) + 2);
    mesh.objects.push_back({"box", "box_" + std::to_string(i + 1), "room"});
  }
  mesh.Validate();
  return mesh;
}

std::vector<std::unique_ptr<const RenderScene>> Scenes(const SceneMesh& mesh) {
  std::vector<std::unique_ptr<const RenderScene>> scenes;
  for (const Kernels* kernels : SupportedKernels()) scenes.push_back(MakeCpuScene(mesh, *kernels));
  scenes.push_back(MakeEglScene(mesh, GlDevice::kAny, ResolveOn::kCpu));
  return scenes;
}

/// The object that each pixel's ray meets first.
std::vector<std::int32_t> Traced(const SceneMesh& mesh, const CameraSpec& camera,
                                 const CameraPose& pose) {
  std::vector<std::int32_t> objects;
  for (const std::int32_t triangle : tests::SeenTriangles(mesh, camera, pose)) {
    objects.push_back(
        triangle < 0
            ? 0
            : static_cast<std::int32_t>(mesh.triangle_objects[static_cast<std::size_t>(triangle)]));
  }
  return objects;
}

const CameraPose kPose = {{2.1f, 1.25f, -2.0f}, 0.3f};

TEST(Objects, AreThoseThatRaysMeet) {
  const SceneMesh mesh = Room();
  const PanoramaSpec panorama{.rows = 64, .cols = 256};
  const PinholeSpec pinhole{.hfov_deg = 80, .rows = 60, .cols = 80, .pitch_deg = -15};
  for (const CameraSpec& camera : {CameraSpec(panorama), CameraSpec(pinhole)}) {
    const std::vector<std::int32_t> wanted = Traced(mesh, camera, kPose);
    for (std::int32_t object = 0; object < 5; ++object) {
      EXPECT_THAT(wanted, testing::Contains(object));
    }
    for (const auto& scene : Scenes(mesh)) {
      EXPECT_TRUE(scene->has_objects());
      const auto renderer = scene->MakeRenderer(camera);
      ASSERT_TRUE(renderer->sees_objects());
      std::vector<std::int32_t> seen(SizeOf(camera).pixels(), -1);
      renderer->RenderObjects({&kPose, 1}, {}, {}, seen);
      std::size_t others = 0;
      for (std::size_t i = 0; i < seen.size(); ++i) others += seen[i] == wanted[i] ? 0 : 1;
      EXPECT_LE(others, seen.size() / 500) << scene->description();  // on edges
    }
  }
}

TEST(Objects, DoNotChangeThePicture) {
  const PanoramaSpec camera{.rows = 32, .cols = 128};
  const std::size_t pixels = SizeOf(camera).pixels();
  SceneMesh bare = Room();
  bare.objects.clear();
  bare.triangle_objects.clear();
  const auto scene = MakeCpuScene(Room());
  const auto bare_scene = MakeCpuScene(bare);
  std::vector<std::uint8_t> color(3 * pixels);
  std::vector<std::uint8_t> bare_color(3 * pixels);
  std::vector<float> depth(pixels);
  std::vector<float> bare_depth(pixels);
  std::vector<std::int32_t> objects(pixels);
  scene->MakeRenderer(camera)->RenderObjects({&kPose, 1}, color, depth, objects);
  bare_scene->MakeRenderer(camera)->Render({&kPose, 1}, bare_color, bare_depth);
  EXPECT_EQ(color, bare_color);
  EXPECT_EQ(depth, bare_depth);
  EXPECT_FALSE(bare_scene->has_objects());
}

TEST(Objects, SpansMustFit) {
  const auto scene = MakeCpuScene(Room());
  const auto renderer = scene->MakeRenderer(PanoramaSpec{.rows = 32, .cols = 128});
  std::vector<std::int32_t> objects(5);
  EXPECT_THROW(renderer->RenderObjects({&kPose, 1}, {}, {}, objects), Error);
}

TEST(Objects, ADeviceThatCannotTellThemSaysSo) {
  const auto scene = MakeEglScene(Room(), GlDevice::kAny, ResolveOn::kDevice);
  const PanoramaSpec camera{.rows = 32, .cols = 128};
  const auto renderer = scene->MakeRenderer(camera);
  EXPECT_FALSE(renderer->sees_objects());
  std::vector<std::int32_t> objects(SizeOf(camera).pixels());
  EXPECT_THROW(renderer->RenderObjects({&kPose, 1}, {}, {}, objects), RenderError);
}

}  // namespace
}  // namespace bulletnav::sim
