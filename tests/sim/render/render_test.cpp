// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <thread>
#include <variant>

#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "sim/math/pose.h"
#include "sim/math/rng.h"
#include "sim/render/cpu/cpu_scene.h"
#include "sim/render/cpu/raycaster.h"
#include "sim/render/egl/egl_scene.h"
#include "sim/render/egl_backend.h"
#include "sim/render/render_mesh.h"
#include "sim/render/renderer.h"
#include "tests/support/panoramas.h"
#include "tests/support/scenes.h"

namespace bulletnav::sim {
namespace {

using tests::AddBox;
using tests::BoxRoom;
using tests::Panorama;
using tests::RenderPanorama;
using Vec = Eigen::Vector3f;

/// Every renderer there is: the CPU's with each kernel, EGL with either second pass.
std::vector<std::unique_ptr<const RenderScene>> AllScenes(const SceneMesh& mesh) {
  std::vector<std::unique_ptr<const RenderScene>> scenes;
  for (const Kernels* kernels : SupportedKernels()) {
    scenes.push_back(MakeCpuScene(mesh, *kernels));
  }
  scenes.push_back(MakeEglScene(mesh, GlDevice::kAny, ResolveOn::kCpu));
  scenes.push_back(MakeEglScene(mesh, GlDevice::kAny, ResolveOn::kDevice));
  return scenes;
}

PanoramaSpec Spec(Projection projection, int rows = 64, int cols = 256) {
  PanoramaSpec spec;
  spec.rows = rows;
  spec.cols = cols;
  spec.projection = projection;
  return spec;
}

constexpr std::array kProjections = {Projection::kCylindrical, Projection::kEquirectangular,
                                     Projection::kCubeStrip};

PinholeSpec Pinhole(double hfov_deg, double pitch_deg, int rows = 96, int cols = 128) {
  PinholeSpec spec;
  spec.hfov_deg = hfov_deg;
  spec.pitch_deg = pitch_deg;
  spec.rows = rows;
  spec.cols = cols;
  return spec;
}

/// Every kind of camera: panoramas, pinholes level, looking up and down, narrow, wide and upright.
std::vector<CameraSpec> AllCameras(int rows = 64, int cols = 256) {
  std::vector<CameraSpec> cameras;
  for (const Projection projection : kProjections) cameras.push_back(Spec(projection, rows, cols));
  const int side = std::min(2 * rows, cols);
  for (const PinholeSpec& spec :
       {Pinhole(90, 0, rows, side), Pinhole(90, -30, rows, side), Pinhole(60, 45, rows, side),
        Pinhole(20, -10, rows, side), Pinhole(150, 15, rows, side), Pinhole(79, -90, rows, side),
        Pinhole(90, 90, rows, side), Pinhole(50, -65, side, rows)}) {
    cameras.push_back(spec);
  }
  return cameras;
}

std::string Describe(const CameraSpec& camera) {
  if (const auto* pinhole = std::get_if<PinholeSpec>(&camera)) {
    return "pinhole of " + std::to_string(pinhole->hfov_deg) + " pitch " +
           std::to_string(pinhole->pitch_deg);
  }
  return "panorama " + std::to_string(static_cast<int>(std::get<PanoramaSpec>(camera).projection));
}

CameraSpec WithDepthLimit(CameraSpec camera, float metres) {
  std::visit(
      [&](auto& spec) {
        spec.max_depth_m = metres;
      },
      camera);
  return camera;
}

/// A room full of random boxes, slivers and specks.
SceneMesh Clutter(std::uint64_t seed) {
  Rng rng(seed, "clutter");
  SceneMesh mesh = BoxRoom(6, 2.6f, 8);
  const auto point = [&rng] {
    const auto z = static_cast<float>(-rng.Uniform(0, 8));
    const auto y = static_cast<float>(rng.Uniform(0, 2.6));
    const auto x = static_cast<float>(rng.Uniform(0, 6));
    return Vec(x, y, z);
  };
  for (int i = 0; i < 150; ++i) {
    const Vec p = point();
    const auto s = static_cast<float>(rng.Chance(0.3) ? 0.6 : rng.Uniform(0.01, 0.2));
    const Rgb8 color = {static_cast<std::uint8_t>(rng.Below(256)),
                        static_cast<std::uint8_t>(rng.Below(256)),
                        static_cast<std::uint8_t>(rng.Below(256))};
    AddBox(p, p + Vec(s, 0.7f * s, 1.3f * s), color, &mesh);
    tests::AddQuad(p, p + Vec(1, 0, 0), p + Vec(1, 0.01f, 0), p + Vec(0, 0.01f, 0.5f), color,
                   &mesh);
  }
  return mesh;
}

TEST(Render, DepthOfABoxRoomIsTheClosedForm) {
  const Vec size(4, 2.6f, 6);
  const CameraPose camera{{1.1f, 1.25f, -2.3f}, 0.6f};
  for (const auto& scene : AllScenes(BoxRoom(size.x(), size.y(), size.z()))) {
    for (const CameraSpec& spec : AllCameras()) {
      const Panorama picture = RenderPanorama(*scene, spec, camera);
      for (int r = 0; r < picture.rows; ++r) {
        for (int c = 0; c < picture.cols; ++c) {
          const Vec d = tests::RayDirection(spec, r, c, camera.yaw);
          float range = 100.0f;
          for (int axis = 0; axis < 3; ++axis) {
            const float low = axis == 2 ? -size.z() : 0.0f;
            const float high = axis == 2 ? 0.0f : size[axis];
            const float wall = d[axis] > 0.0f ? high : low;
            if (std::abs(d[axis]) > 1e-6f) {
              range = std::min(range, (wall - camera.position[axis]) / d[axis]);
            }
          }
          ASSERT_NEAR(picture.depth_at(r, c), range, 2e-3f * range)
              << scene->description() << " " << Describe(spec) << " row " << r << " column " << c;
        }
      }
    }
  }
}

TEST(Render, ColumnsRunClockwiseFromBehindAndTheMiddleLooksForward) {
  // BoxRoom: ahead (-z) red, behind green, left blue, right yellow.
  const CameraPose camera{{2, 1.3f, -3}, 0.0f};
  for (const auto& scene : AllScenes(BoxRoom(4, 2.6f, 6))) {
    for (const Projection projection : {Projection::kCylindrical, Projection::kEquirectangular}) {
      const PanoramaSpec spec = Spec(projection);
      const Panorama picture = RenderPanorama(*scene, spec, camera);
      const int middle = spec.rows / 2;
      EXPECT_EQ(picture.color_at(middle, 0), (Rgb8{60, 200, 60}));
      EXPECT_EQ(picture.color_at(middle, spec.cols / 4), (Rgb8{60, 60, 200}));
      EXPECT_EQ(picture.color_at(middle, spec.cols / 2), (Rgb8{200, 60, 60}));
      EXPECT_EQ(picture.color_at(middle, 3 * spec.cols / 4), (Rgb8{200, 200, 60}));
      const Panorama turned = RenderPanorama(*scene, spec, {camera.position, 0.5f * float(kPi)});
      EXPECT_EQ(turned.color_at(middle, spec.cols / 2), (Rgb8{60, 60, 200})) << "turned left";
    }
  }
}

TEST(Render, TexturesStandUprightAndReadFromLeftToRight) {
  SceneMesh mesh = BoxRoom(4, 2.6f, 6);
  Texture texture{"quarters", Image(64, 64, 4)};
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      std::uint8_t* p = texture.image.at(x, y);
      p[0] = x < 32 ? 250 : 10;  // red on the left
      p[1] = y < 32 ? 250 : 10;  // green above
      p[2] = 0;
      p[3] = 255;
    }
  }
  mesh.textures.push_back(texture);
  mesh.materials[2].base_color = kWhite;  // the wall ahead
  mesh.materials[2].texture = 0;
  const PanoramaSpec spec = Spec(Projection::kCylindrical, 128, 512);
  for (const auto& scene : AllScenes(mesh)) {
    const Panorama picture = RenderPanorama(*scene, spec, {{2, 1.3f, -3}, 0.0f});
    EXPECT_EQ(picture.color_at(54, 246), (Rgb8{250, 250, 0}));
    EXPECT_EQ(picture.color_at(54, 266), (Rgb8{10, 250, 0}));
    EXPECT_EQ(picture.color_at(74, 246), (Rgb8{250, 10, 0}));
    EXPECT_EQ(picture.color_at(74, 266), (Rgb8{10, 10, 0}));
  }
}

TEST(Render, APinholePictureShowsWhatIsAheadUprightAndFromLeftToRight) {
  // BoxRoom: ahead (-z) red, behind green, left blue, right yellow.
  const CameraPose camera{{2, 1.3f, -3}, 0.0f};
  for (const auto& scene : AllScenes(BoxRoom(4, 2.6f, 6))) {
    const Panorama level = RenderPanorama(*scene, Pinhole(120, 0), camera);
    const int middle = level.rows / 2;
    EXPECT_EQ(level.color_at(middle, level.cols / 2), (Rgb8{200, 60, 60}));
    EXPECT_EQ(level.color_at(middle, 0), (Rgb8{60, 60, 200}));
    EXPECT_EQ(level.color_at(middle, level.cols - 1), (Rgb8{200, 200, 60}));
    const Panorama turned = RenderPanorama(*scene, Pinhole(60, 0), {camera.position, float(kPi)});
    EXPECT_EQ(turned.color_at(middle, turned.cols / 2), (Rgb8{60, 200, 60}));
    const Rgb8 floor = level.color_at(level.rows - 1, level.cols / 2);
    const Rgb8 ceiling = level.color_at(0, level.cols / 2);
    EXPECT_NE(floor, ceiling);
    const Panorama down = RenderPanorama(*scene, Pinhole(60, -90), camera);
    EXPECT_EQ(down.color_at(middle, down.cols / 2), floor);
    const Panorama up = RenderPanorama(*scene, Pinhole(60, 90), camera);
    EXPECT_EQ(up.color_at(middle, up.cols / 2), ceiling);
  }
}

TEST(Render, ThePictureOfAPinholeIsAsWideAsItsFieldOfView) {
  // A wall 3 m ahead of the eye, 3 m above and below it: 90 degrees end where it does.
  SceneMesh mesh;
  tests::AddQuad({-3, -3, -3}, {3, -3, -3}, {3, 3, -3}, {-3, 3, -3}, {80, 90, 100}, &mesh);
  const CameraPose camera{Vec::Zero(), 0.0f};
  for (const auto& scene : AllScenes(mesh)) {
    const Panorama fits = RenderPanorama(*scene, Pinhole(89.9, 0, 128, 128), camera);
    EXPECT_EQ(std::count(fits.depth.begin(), fits.depth.end(), 0.0f), 0);
    EXPECT_NEAR(fits.depth_at(63, 63), 3.0f, 0.01f);
    EXPECT_NEAR(fits.depth_at(0, 0), 3.0f * std::sqrt(3.0f), 0.08f);
    const Panorama wide = RenderPanorama(*scene, Pinhole(100, 0, 128, 128), camera);
    const float half = 64.0f / std::tan(0.5f * 100.0f * float(kPi) / 180.0f);
    for (int c = 0; c < 128; ++c) {
      const float off = std::abs(static_cast<float>(c) + 0.5f - 64.0f);
      EXPECT_EQ(wide.depth_at(64, c) > 0.0f, off < half) << scene->description() << " " << c;
      EXPECT_EQ(wide.depth_at(c, 64) > 0.0f, off < half) << scene->description() << " " << c;
    }
    // Turned up by 45 degrees, the wall's upper edge is in the middle.
    const Panorama up = RenderPanorama(*scene, Pinhole(60, 45, 128, 128), camera);
    EXPECT_EQ(up.depth_at(60, 64), 0.0f);
    EXPECT_NEAR(up.depth_at(66, 64), 3.0f * std::sqrt(2.0f), 0.2f);
  }
}

TEST(Render, APinholePictureAndAPanoramaAgreeAboutColours) {
  // The same texture seen the same way: a cube strip's side and a 90-degree pinhole.
  const SceneMesh mesh = Clutter(9);
  for (const auto& scene : AllScenes(mesh)) {
    const CameraPose camera{{3, 1.25f, -4}, 0.7f};
    const Panorama strip = RenderPanorama(*scene, Spec(Projection::kCubeStrip, 64, 256), camera);
    const float side_yaw = camera.yaw + 0.25f * float(kPi);  // the second side of four
    const Panorama flat =
        RenderPanorama(*scene, Pinhole(90, 0, 64, 64), {camera.position, side_yaw});
    int different = 0;
    for (int r = 0; r < 64; ++r) {
      for (int c = 0; c < 64; ++c) {
        const bool same = std::abs(flat.depth_at(r, c) - strip.depth_at(r, 64 + c)) < 0.01f &&
                          flat.color_at(r, c) == strip.color_at(r, 64 + c);
        different += same ? 0 : 1;
      }
    }
    EXPECT_LT(different, 40) << scene->description();
  }
}

TEST(Render, VertexColoursBlendAcrossATriangle) {
  SceneMesh mesh = BoxRoom(4, 2.6f, 6);
  mesh.materials[2].base_color = kWhite;
  for (std::size_t v = 8; v < 12; ++v) {  // corners of the wall ahead
    const bool right = mesh.positions[v].x() > 2.0f;
    mesh.colors[v] = right ? Rgb8{200, 0, 0} : Rgb8{0, 0, 0};
  }
  const PanoramaSpec spec = Spec(Projection::kCylindrical, 128, 512);
  for (const auto& scene : AllScenes(mesh)) {
    const Panorama picture = RenderPanorama(*scene, spec, {{2, 1.3f, -3}, 0.0f});
    for (const int c : {232, 256, 280}) {
      const Vec d = tests::RayDirection(spec, 64, c, 0.0f);
      const float x = 2.0f + d.x() / -d.z() * 3.0f;
      EXPECT_NEAR(picture.color_at(64, c)[0], 50.0f * x, 2.0f);
    }
  }
}

TEST(Render, NothingIsBlackWithoutDepthAndFarIsClipped) {
  SceneMesh mesh;
  tests::AddQuad({-1, -3, -30}, {1, -3, -30}, {1, 3, -30}, {-1, 3, -30}, {80, 90, 100}, &mesh);
  PanoramaSpec spec = Spec(Projection::kCylindrical, 128, 512);
  for (const auto& scene : AllScenes(mesh)) {
    const Panorama picture = RenderPanorama(*scene, spec, {Vec::Zero(), 0.0f});
    EXPECT_EQ(picture.depth_at(64, 256), 10.0f);
    EXPECT_EQ(picture.color_at(64, 256), (Rgb8{80, 90, 100}));
    EXPECT_EQ(picture.depth_at(64, 0), 0.0f);
    EXPECT_EQ(picture.color_at(64, 0), (Rgb8{0, 0, 0}));
  }
}

/// Pixels of a picture that are off the depth along Embree's rays.
int WrongPixels(const SceneMesh& mesh, const RenderScene& scene, const CameraSpec& spec,
                const CameraPose& camera) {
  const RenderMesh triangles(mesh);
  const Raycaster raycaster(triangles.corners);
  const Panorama picture = RenderPanorama(scene, spec, camera);
  int wrong = 0;
  for (int r = 0; r < picture.rows; ++r) {
    for (int c = 0; c < picture.cols; ++c) {
      const RayHit hit =
          raycaster.Cast(camera.position, tests::RayDirection(spec, r, c, camera.yaw));
      const float expected = hit.triangle < 0 ? 0.0f : std::min(hit.t, MaxDepthOf(spec));
      const float error = std::abs(picture.depth_at(r, c) - expected);
      wrong += error > 1e-3f * expected + 1e-3f ? 1 : 0;
    }
  }
  return wrong;
}

TEST(Render, TheSweepFindsWhatEmbreesRaysFind) {
  const SceneMesh mesh = Clutter(1);
  const auto scene = MakeCpuScene(mesh);
  Rng rng(2, "cameras");
  for (const CameraSpec& camera_spec : AllCameras(96, 400)) {
    const CameraSpec spec = WithDepthLimit(camera_spec, 100.0f);
    int wrong = 0;
    for (int i = 0; i < 6; ++i) {
      const CameraPose camera{{static_cast<float>(rng.Uniform(0.1, 5.9)), 1.25f,
                               static_cast<float>(-rng.Uniform(0.1, 7.9))},
                              static_cast<float>(rng.Uniform(-3, 3))};
      wrong += WrongPixels(mesh, *scene, spec, camera);
    }
    // Rays that graze an edge may fall on either side of it.
    EXPECT_LT(wrong, 40) << Describe(spec) << " of " << 6 * SizeOf(spec).pixels();
  }
}

SceneMesh Soup(const std::vector<std::array<Vec, 3>>& triangles) {
  SceneMesh mesh;
  mesh.materials.emplace_back();
  for (const auto& corners : triangles) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const Vec& corner : corners) mesh.positions.push_back(corner);
    mesh.uvs.resize(mesh.positions.size(), Eigen::Vector2f::Zero());
    mesh.colors.resize(mesh.positions.size(), kWhite);
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangle_materials.push_back(0);
  }
  return mesh;
}

TEST(Render, AFloorOfOneTriangleIsSeenToTheFeet) {
  // Acute, with the camera over its middle: all of it is nearer than its edges.
  const SceneMesh mesh = Soup({{Vec(0, 0, -11), Vec(-10, 0, 6), Vec(10, 0, 6)}});
  for (const auto& scene : AllScenes(mesh)) {
    for (const CameraSpec& spec : AllCameras()) {
      EXPECT_LT(WrongPixels(mesh, *scene, spec, {{0, 1.25f, 0}, 0.3f}), 20)
          << scene->description() << " " << Describe(spec);
    }
  }
}

TEST(Render, TheSweepFindsTrianglesOfAnySizeAndShape) {
  Rng rng(5, "soup");
  for (int trial = 0; trial < 220; ++trial) {
    std::vector<std::array<Vec, 3>> triangles;
    for (int t = 0; t <= trial / 4; ++t) {
      const double size = std::exp(rng.Uniform(std::log(0.01), std::log(20.0)));
      // Half of them lie almost level, as floors and tables do.
      const double height = rng.Chance(0.5) ? 0.02 : 1.0;
      const auto point = [&rng](double reach, double level) {
        const double x = rng.Uniform(-reach, reach);
        const double y = rng.Uniform(-reach, reach) * level;
        const double z = rng.Uniform(-reach, reach);
        return Vec(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
      };
      const Vec centre = rng.Chance(0.3) ? Vec(0, point(4.0, 1.0).y(), 0) : point(4.0, 1.0);
      const Vec a = centre + point(size, height);
      const Vec b = centre + point(size, height);
      const Vec c = centre + point(size, height);
      triangles.push_back({a, b, c});
    }
    const SceneMesh mesh = Soup(triangles);
    const std::vector<CameraSpec> cameras = AllCameras();
    const CameraSpec& spec = cameras[static_cast<std::size_t>(trial) % cameras.size()];
    const auto scene = MakeCpuScene(mesh);
    // Rays that graze an edge may fall on either side of it.
    EXPECT_LT(WrongPixels(mesh, *scene, spec, {Vec::Zero(), 0.1f * static_cast<float>(trial)}), 20)
        << "trial " << trial << " " << Describe(spec);
  }
}

/// A camera in Clutter that stays as far from everything as a body does.
CameraPose RoomyPlace(const RenderScene& scene, Rng* rng) {
  for (;;) {
    const CameraPose camera{
        {static_cast<float>(rng->Uniform(1, 5)), 1.25f, static_cast<float>(-rng->Uniform(1, 7))},
        static_cast<float>(rng->Uniform(-3, 3))};
    const Panorama around = RenderPanorama(scene, Spec(Projection::kEquirectangular), camera);
    if (*std::min_element(around.depth.begin(), around.depth.end()) > 0.15f) return camera;
  }
}

TEST(Render, BothBackendsDrawTheSamePicture) {
  const SceneMesh mesh = Clutter(3);
  const auto embree = MakeCpuScene(mesh);
  Rng rng(4, "cameras");
  for (const ResolveOn resolve : {ResolveOn::kCpu, ResolveOn::kDevice}) {
    const auto egl = MakeEglScene(mesh, GlDevice::kAny, resolve);
    for (const CameraSpec& spec : AllCameras(128, 512)) {
      tests::Agreement agreement;
      for (int i = 0; i < 4; ++i) {
        const CameraPose camera = RoomyPlace(*embree, &rng);
        agreement.Add(RenderPanorama(*embree, spec, camera), RenderPanorama(*egl, spec, camera));
      }
      EXPECT_GE(agreement.depth(), 0.995) << egl->description() << " " << Describe(spec);
      EXPECT_GE(agreement.color(), 0.99) << egl->description() << " " << Describe(spec);
    }
  }
}

TEST(Render, AllKernelsDrawTheSameBits) {
  const SceneMesh mesh = Clutter(5);
  const CameraPose camera{{3, 1.25f, -4}, 1.0f};
  // An odd size: the last vector of a row is only partly used.
  for (const CameraSpec& spec : AllCameras(50, 204)) {
    const Panorama best = RenderPanorama(*MakeCpuScene(mesh), spec, camera);
    for (const Kernels* kernels : SupportedKernels()) {
      const Panorama other = RenderPanorama(*MakeCpuScene(mesh, *kernels), spec, camera);
      EXPECT_EQ(other.color, best.color) << kernels->name;
      EXPECT_EQ(other.depth, best.depth) << kernels->name;
    }
  }
}

void CompareWithSinglePictures(const RenderScene& scene, const CameraSpec& spec,
                               const std::vector<CameraPose>& cameras) {
  const std::size_t pixels = SizeOf(spec).pixels();
  std::vector<std::uint8_t> color(3 * pixels * cameras.size());
  std::vector<float> depth(pixels * cameras.size());
  std::thread elsewhere([&] {
    scene.MakeRenderer(spec)->Render(cameras, color, depth);
  });
  std::vector<Panorama> single;
  for (const CameraPose& camera : cameras) single.push_back(RenderPanorama(scene, spec, camera));
  elsewhere.join();
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    const std::vector<float> part(depth.begin() + long(pixels * i),
                                  depth.begin() + long(pixels * (i + 1)));
    EXPECT_EQ(part, single[i].depth) << scene.description() << " " << Describe(spec);
    const std::vector<std::uint8_t> colors(color.begin() + long(3 * pixels * i),
                                           color.begin() + long(3 * pixels * (i + 1)));
    EXPECT_EQ(colors, single[i].color) << scene.description() << " " << Describe(spec);
  }
}

TEST(Render, ABatchIsTheSameAsOneByOneAndThreadsDoNotMatter) {
  const SceneMesh mesh = Clutter(6);
  std::vector<CameraPose> cameras;
  for (int i = 0; i < 5; ++i) cameras.push_back({{1.0f + 0.8f * float(i), 1.25f, -4}, 0.3f});
  for (const auto& scene : AllScenes(mesh)) {
    CompareWithSinglePictures(*scene, Spec(Projection::kCylindrical), cameras);
    CompareWithSinglePictures(*scene, Pinhole(90, -20, 51, 67), cameras);
  }
}

TEST(Render, ColourOrDepthAlone) {
  const SceneMesh mesh = BoxRoom(4, 2.6f, 6);
  const PanoramaSpec spec = Spec(Projection::kCylindrical);
  const CameraPose camera{{2, 1.25f, -3}, 0.0f};
  for (const auto& scene : AllScenes(mesh)) {
    const Panorama both = RenderPanorama(*scene, spec, camera);
    std::vector<std::uint8_t> color(3 * spec.pixels());
    std::vector<float> depth(spec.pixels());
    scene->MakeRenderer(spec)->Render({&camera, 1}, color, {});
    scene->MakeRenderer(spec)->Render({&camera, 1}, {}, depth);
    EXPECT_EQ(color, both.color);
    EXPECT_EQ(depth, both.depth);
  }
}

TEST(Render, BadSizesAreRefused) {
  const auto scene = MakeRenderScene(BoxRoom(4, 2.6f, 6), Backend::kEmbree);
  for (const auto& [rows, cols] :
       {std::pair{0, 512}, {128, 0}, {128, 100000}, {-1, 512}, {100000, 512}}) {
    EXPECT_THROW(scene->MakeRenderer(Spec(Projection::kCylindrical, rows, cols)), Error);
  }
  EXPECT_THROW(scene->MakeRenderer(Spec(Projection::kCubeStrip, 128, 510)), Error);
  for (const PinholeSpec& bad :
       {Pinhole(90, 0, 0, 640), Pinhole(180, 0), Pinhole(0, 0), Pinhole(std::nan(""), 0),
        Pinhole(90, 91), Pinhole(90, -91), Pinhole(150, 0, 4096, 128)}) {
    EXPECT_THROW(scene->MakeRenderer(bad), Error) << Describe(bad);
  }
  EXPECT_THROW(scene->MakeRenderer(WithDepthLimit(Pinhole(90, 0), 0.0f)), Error);
}

TEST(Render, SpansThatDoNotFitAndPosesThatAreNoneAreRefused) {
  const PanoramaSpec spec = Spec(Projection::kCylindrical);
  std::vector<float> depth(spec.pixels());
  const CameraPose good{{2, 1.25f, -3}, 0.0f};
  const CameraPose bad{{2, std::nanf(""), -3}, 0.0f};
  for (const auto& scene : AllScenes(BoxRoom(4, 2.6f, 6))) {
    const auto renderer = scene->MakeRenderer(spec);
    EXPECT_THROW(renderer->Render({&good, 1}, {}, std::span(depth).first(9)), Error);
    EXPECT_THROW(renderer->Render({&bad, 1}, {}, depth), Error) << scene->description();
  }
}

TEST(Render, AutoWorksWithoutAGraphicsProcessor) {
  const auto scene = MakeRenderScene(BoxRoom(4, 2.6f, 6), Backend::kAuto);
  EXPECT_EQ(scene->backend(), HasHardwareGpu() ? Backend::kEgl : Backend::kEmbree);
}

TEST(Render, LargeFinePicturesWork) {
  const SceneMesh mesh = Clutter(7);
  const PanoramaSpec spec = Spec(Projection::kCylindrical, 512, 2048);
  const CameraPose camera{{3, 1.25f, -4}, 1.0f};
  tests::Agreement agreement;
  agreement.Add(RenderPanorama(*MakeCpuScene(mesh), spec, camera),
                RenderPanorama(*MakeEglScene(mesh, GlDevice::kAny), spec, camera));
  EXPECT_GE(agreement.depth(), 0.995);
  EXPECT_GE(agreement.color(), 0.99);
}

}  // namespace
}  // namespace bulletnav::sim
