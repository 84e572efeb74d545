// SPDX-License-Identifier: MIT
// Pictures without triangles seen from behind.
#include <algorithm>

#include <gtest/gtest.h>

#include "sim/render/cpu/cpu_scene.h"
#include "sim/render/egl/egl_scene.h"
#include "sim/render/egl_backend.h"
#include "tests/support/panoramas.h"
#include "tests/support/scenes.h"

namespace bulletnav::sim {
namespace {

using tests::AddBox;
using tests::AddQuad;
using tests::Panorama;
using tests::RenderPanorama;
using Vec = Eigen::Vector3f;

const CameraPose kCamera = {{3, 1.25f, -4}, 0.4f};

std::vector<std::unique_ptr<const RenderScene>> AllScenes(const SceneMesh& mesh) {
  std::vector<std::unique_ptr<const RenderScene>> scenes;
  for (const Kernels* kernels : SupportedKernels()) scenes.push_back(MakeCpuScene(mesh, *kernels));
  scenes.push_back(MakeEglScene(mesh, GlDevice::kAny, ResolveOn::kCpu));
  scenes.push_back(MakeEglScene(mesh, GlDevice::kAny, ResolveOn::kDevice));
  return scenes;
}

/// A closed room with closed things in it, all of which face where a body can be.
SceneMesh ClosedRoom() {
  SceneMesh mesh = tests::BoxRoom(6, 2.6f, 8);
  AddBox({1, 0, -3}, {2, 0.8f, -2}, {90, 60, 30}, &mesh);
  AddBox({4, 0, -7}, {4.5f, 2, -6}, {30, 60, 90}, &mesh);
  AddBox({2, 1, -6}, {3, 1.1f, -5}, {150, 20, 90}, &mesh);
  return mesh;
}

SceneMesh WithoutBackFaces(SceneMesh mesh) {
  mesh.back_faces = false;
  return mesh;
}

TEST(BackFaces, ArePartOfThePictureUnlessLeftOut) {
  SceneMesh mesh = ClosedRoom();
  // An upright sheet a metre before the camera that faces away from it.
  AddQuad({4, 0, -5}, {2, 0, -5}, {2, 2.6f, -5}, {4, 2.6f, -5}, {1, 2, 3}, &mesh);
  for (const auto& scene : AllScenes(mesh)) {
    EXPECT_NEAR(RenderPanorama(*scene, PanoramaSpec{}, {{3, 1.25f, -4}, 0}).depth_at(64, 256), 1.0f,
                0.01f)
        << scene->description();
  }
  for (const auto& scene : AllScenes(WithoutBackFaces(mesh))) {
    EXPECT_NEAR(RenderPanorama(*scene, PanoramaSpec{}, {{3, 1.25f, -4}, 0}).depth_at(64, 256), 4.0f,
                0.01f)
        << scene->description();
    EXPECT_NEAR(RenderPanorama(*scene, PanoramaSpec{}, {{3, 1.25f, -7}, 0}).depth_at(64, 0), 2.0f,
                0.01f)
        << scene->description();
  }
}

TEST(BackFaces, OfClosedThingsAreNotMissed) {
  PinholeSpec down;
  down.pitch_deg = -35;
  for (const CameraSpec& spec : {CameraSpec(PanoramaSpec{}), CameraSpec(down)}) {
    const auto all = AllScenes(ClosedRoom());
    const auto fronts = AllScenes(WithoutBackFaces(ClosedRoom()));
    for (std::size_t i = 0; i < all.size(); ++i) {
      tests::Agreement agreement;
      agreement.Add(RenderPanorama(*all[i], spec, kCamera),
                    RenderPanorama(*fronts[i], spec, kCamera));
      EXPECT_GE(agreement.depth(), 0.9999) << all[i]->description();
      EXPECT_GE(agreement.color(), 0.9999) << all[i]->description();
    }
  }
}

TEST(BackFaces, KernelsDrawTheSameBitsWithoutThem) {
  SceneMesh mesh = WithoutBackFaces(ClosedRoom());
  AddQuad({4, 0, -5}, {2, 0, -5}, {2, 2, -5}, {4, 2, -5}, {1, 2, 3}, &mesh);
  const Panorama best = RenderPanorama(*MakeCpuScene(mesh), PanoramaSpec{}, kCamera);
  for (const Kernels* kernels : SupportedKernels()) {
    const Panorama other = RenderPanorama(*MakeCpuScene(mesh, *kernels), PanoramaSpec{}, kCamera);
    EXPECT_EQ(other.color, best.color) << kernels->name;
    EXPECT_EQ(other.depth, best.depth) << kernels->name;
  }
}

}  // namespace
}  // namespace bulletnav::sim
