// SPDX-License-Identifier: MIT
#include "sim/import/primitives.h"

#include <numbers>

#include "sim/base/elementary.h"

namespace bulletnav::sim {
namespace {

using Vec = Eigen::Vector3f;

constexpr std::uint32_t kSides = 32;
constexpr std::uint32_t kRings = 16;  // from pole to pole

SceneMesh Empty() {
  SceneMesh mesh;
  mesh.materials.push_back({"", kWhite, -1});
  return mesh;
}

std::uint32_t AddVertex(const Vec& p, SceneMesh* mesh) {
  mesh->positions.push_back(p);
  mesh->uvs.emplace_back(0.0f, 0.0f);
  mesh->colors.push_back(kWhite);
  return static_cast<std::uint32_t>(mesh->positions.size()) - 1;
}

void AddTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, SceneMesh* mesh) {
  mesh->triangles.push_back({a, b, c});
  mesh->triangle_materials.push_back(0);
}

void AddQuad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d, SceneMesh* mesh) {
  AddTriangle(a, b, c, mesh);
  AddTriangle(a, c, d, mesh);
}

float Angle(std::uint32_t step, std::uint32_t of_turn) {
  return 2.0f * std::numbers::pi_v<float> * static_cast<float>(step) / static_cast<float>(of_turn);
}

}  // namespace

SceneMesh BoxShape(const Vec& size) {
  SceneMesh mesh = Empty();
  for (unsigned i = 0; i < 8; ++i) {
    const Vec corner((i & 1) != 0 ? 0.5f : -0.5f, (i & 2) != 0 ? 0.5f : -0.5f,
                     (i & 4) != 0 ? 0.5f : -0.5f);
    AddVertex(corner.cwiseProduct(size), &mesh);
  }
  AddQuad(0, 2, 3, 1, &mesh);
  AddQuad(4, 5, 7, 6, &mesh);
  AddQuad(0, 1, 5, 4, &mesh);
  AddQuad(2, 6, 7, 3, &mesh);
  AddQuad(0, 4, 6, 2, &mesh);
  AddQuad(1, 3, 7, 5, &mesh);
  return mesh;
}

SceneMesh CylinderShape(float radius, float length) {
  SceneMesh mesh = Empty();
  const std::uint32_t bottom = AddVertex({0.0f, 0.0f, -0.5f * length}, &mesh);
  const std::uint32_t top = AddVertex({0.0f, 0.0f, 0.5f * length}, &mesh);
  for (std::uint32_t i = 0; i < kSides; ++i) {
    const float x = radius * Cos(Angle(i, kSides));
    const float y = radius * Sin(Angle(i, kSides));
    AddVertex({x, y, -0.5f * length}, &mesh);
    AddVertex({x, y, 0.5f * length}, &mesh);
  }
  for (std::uint32_t i = 0; i < kSides; ++i) {
    const std::uint32_t here = 2 + 2 * i;
    const std::uint32_t next = 2 + 2 * ((i + 1) % kSides);
    AddQuad(here, next, next + 1, here + 1, &mesh);
    AddTriangle(bottom, next, here, &mesh);
    AddTriangle(top, here + 1, next + 1, &mesh);
  }
  return mesh;
}

SceneMesh EllipsoidShape(const Vec& radii) {
  SceneMesh mesh = Empty();
  for (std::uint32_t ring = 0; ring <= kRings; ++ring) {
    const float polar = Angle(ring, 2 * kRings);
    for (std::uint32_t i = 0; i < kSides; ++i) {
      const Vec p(Sin(polar) * Cos(Angle(i, kSides)), Sin(polar) * Sin(Angle(i, kSides)),
                  -Cos(polar));
      AddVertex(p.cwiseProduct(radii), &mesh);
    }
  }
  for (std::uint32_t ring = 0; ring < kRings; ++ring) {
    for (std::uint32_t i = 0; i < kSides; ++i) {
      const std::uint32_t here = ring * kSides + i;
      const std::uint32_t next = ring * kSides + (i + 1) % kSides;
      AddQuad(here, next, next + kSides, here + kSides, &mesh);
    }
  }
  return mesh;
}

SceneMesh PlaneShape(const Eigen::Vector2f& size) {
  SceneMesh mesh = Empty();
  for (const float y : {-0.5f, 0.5f}) {
    for (const float x : {-0.5f, 0.5f}) AddVertex({x * size.x(), y * size.y(), 0.0f}, &mesh);
  }
  AddQuad(0, 1, 3, 2, &mesh);
  return mesh;
}

}  // namespace bulletnav::sim
