// SPDX-License-Identifier: MIT
// Which pixels show glass, against rays.
#include <algorithm>

#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "sim/render/cpu/cpu_scene.h"
#include "sim/render/egl/egl_scene.h"
#include "tests/support/scenes.h"
#include "tests/support/seen_triangles.h"

namespace bulletnav::sim {
namespace {

const CameraPose kPose = {{2.1f, 1.25f, -2.0f}, 0.3f};

/// A room with a window in its far wall and a mirror beside the camera.
SceneMesh Room(const std::string& pane) {
  SceneMesh mesh = tests::BoxRoom(4, 2.6f, 6);
  const auto glazed = static_cast<std::uint32_t>(mesh.materials.size());
  tests::AddQuad({1, 0.8f, -5.9f}, {3, 0.8f, -5.9f}, {3, 2, -5.9f}, {1, 2, -5.9f}, kWhite, &mesh);
  tests::AddQuad({0.1f, 0.5f, -1}, {0.1f, 0.5f, -2}, {0.1f, 2, -2}, {0.1f, 2, -1}, kWhite, &mesh);
  for (std::size_t m = glazed; m < mesh.materials.size(); ++m) mesh.materials[m].name = pane;
  for (std::size_t t = mesh.triangles.size() - 4; t < mesh.triangles.size(); ++t) {
    EXPECT_GE(mesh.triangle_materials[t], glazed);
  }
  mesh.Validate();
  return mesh;
}

std::vector<std::unique_ptr<const RenderScene>> Scenes(const SceneMesh& mesh) {
  std::vector<std::unique_ptr<const RenderScene>> scenes;
  for (const Kernels* kernels : SupportedKernels()) scenes.push_back(MakeCpuScene(mesh, *kernels));
  for (const ResolveOn resolve : {ResolveOn::kCpu, ResolveOn::kDevice}) {
    scenes.push_back(MakeEglScene(mesh, GlDevice::kAny, resolve));
  }
  return scenes;
}

/// Whether each pixel's ray meets a pane first: one of the last four triangles.
std::vector<std::uint8_t> Traced(const SceneMesh& mesh, const CameraSpec& camera) {
  std::vector<std::uint8_t> glass;
  for (const std::int32_t triangle : tests::SeenTriangles(mesh, camera, kPose)) {
    glass.push_back(triangle >= static_cast<int>(mesh.triangles.size()) - 4 ? 1 : 0);
  }
  return glass;
}

TEST(GlassSeen, IsWhereRaysMeetIt) {
  const SceneMesh mesh = Room("Window");
  const PanoramaSpec panorama{.rows = 64, .cols = 256};
  const PinholeSpec pinhole{.hfov_deg = 80, .rows = 60, .cols = 80, .pitch_deg = 10};
  for (const CameraSpec& camera : {CameraSpec(panorama), CameraSpec(pinhole)}) {
    const std::vector<std::uint8_t> wanted = Traced(mesh, camera);
    const std::size_t pixels = wanted.size();
    EXPECT_GT(std::count(wanted.begin(), wanted.end(), 1), static_cast<int>(pixels) / 50);
    for (const auto& scene : Scenes(mesh)) {
      EXPECT_TRUE(scene->has_glass());
      const auto renderer = scene->MakeRenderer(camera);
      std::vector<float> depth(pixels);
      std::vector<float> plain(pixels);
      std::vector<std::uint8_t> glass(pixels, 7);
      renderer->Draw({&kPose, 1}, {{}, depth, {}, glass});
      renderer->Render({&kPose, 1}, {}, plain);
      EXPECT_EQ(depth, plain) << scene->description();
      EXPECT_TRUE(std::all_of(depth.begin(), depth.end(), [](float d) {
        return d > 0.0f;
      }));
      std::size_t others = 0;
      for (std::size_t i = 0; i < pixels; ++i) others += glass[i] == wanted[i] ? 0 : 1;
      EXPECT_LE(others, pixels / 200) << scene->description();  // on edges
    }
  }
}

TEST(GlassSeen, IsNowhereWithoutAny) {
  const PanoramaSpec camera{.rows = 32, .cols = 128};
  for (const auto& scene : Scenes(Room("wallpaper"))) {
    EXPECT_FALSE(scene->has_glass());
    std::vector<std::uint8_t> glass(SizeOf(camera).pixels(), 7);
    scene->MakeRenderer(camera)->Draw({&kPose, 1}, {{}, {}, {}, glass});
    EXPECT_EQ(std::count(glass.begin(), glass.end(), 0), std::ssize(glass));
  }
}

TEST(GlassSeen, ANameDoesNotChangeThePicture) {
  const PanoramaSpec camera{.rows = 32, .cols = 128};
  const auto drawn = [&](const RenderScene& scene) {
    std::vector<std::uint8_t> color(3 * SizeOf(camera).pixels());
    scene.MakeRenderer(camera)->Render({&kPose, 1}, color, {});
    return color;
  };
  const auto glazed = Scenes(Room("glass"));
  const auto papered = Scenes(Room("wallpaper"));
  for (std::size_t i = 0; i < glazed.size(); ++i) EXPECT_EQ(drawn(*glazed[i]), drawn(*papered[i]));
}

TEST(GlassSeen, SpansMustFit) {
  const auto scene = MakeCpuScene(Room("glass"));
  std::vector<std::uint8_t> glass(5);
  EXPECT_THROW(scene->MakeRenderer(PanoramaSpec())->Draw({&kPose, 1}, {{}, {}, {}, glass}), Error);
}

}  // namespace
}  // namespace bulletnav::sim
