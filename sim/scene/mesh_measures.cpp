// SPDX-License-Identifier: MIT
#include "sim/scene/mesh_measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace bulletnav::sim {
namespace {

constexpr float kLevel = 0.9f;        // vertical part of a level face's normal, at least
constexpr float kOnTheFloor = 0.15f;  // metres
constexpr float kFloorStep = 0.1f;    // metres that heights are counted in
constexpr double kFloorShare = 0.5;   // of the largest level's area: a roof may be larger than it
constexpr double kLightest = 255.0;

std::array<float, 3> HeightsOf(const SceneMesh& mesh, std::size_t triangle) {
  const auto& corners = mesh.triangles[triangle];
  return {mesh.positions[corners[0]].y(), mesh.positions[corners[1]].y(),
          mesh.positions[corners[2]].y()};
}

}  // namespace

Eigen::Vector3f NormalOf(const SceneMesh& mesh, std::size_t triangle) {
  const auto& corners = mesh.triangles[triangle];
  const Eigen::Vector3f& a = mesh.positions[corners[0]];
  return (mesh.positions[corners[1]] - a).cross(mesh.positions[corners[2]] - a);
}

Eigen::Vector3f CentreOf(const SceneMesh& mesh, std::size_t triangle) {
  const auto& corners = mesh.triangles[triangle];
  return (mesh.positions[corners[0]] + mesh.positions[corners[1]] + mesh.positions[corners[2]]) /
         3.0f;
}

double AreaOf(const SceneMesh& mesh, std::size_t triangle) {
  return 0.5 * double{NormalOf(mesh, triangle).norm()};
}

bool IsLevel(const SceneMesh& mesh, std::size_t triangle) {
  const Eigen::Vector3f normal = NormalOf(mesh, triangle);
  return std::abs(normal.y()) >= kLevel * normal.norm();
}

float LowestOf(const SceneMesh& mesh, std::size_t triangle) {
  const auto heights = HeightsOf(mesh, triangle);
  return *std::min_element(heights.begin(), heights.end());
}

float HighestOf(const SceneMesh& mesh, std::size_t triangle) {
  const auto heights = HeightsOf(mesh, triangle);
  return *std::max_element(heights.begin(), heights.end());
}

float FloorHeight(const SceneMesh& mesh) {
  std::map<int, double> areas;  // by height in steps
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Eigen::Vector3f normal = NormalOf(mesh, t);
    if (normal.y() <= kLevel * normal.norm()) continue;
    areas[static_cast<int>(std::floor(LowestOf(mesh, t) / kFloorStep))] += double{normal.y()};
  }
  if (areas.empty()) return mesh.Bounds().min().y();
  const auto most = std::max_element(areas.begin(), areas.end(), [](const auto& a, const auto& b) {
    return a.second < b.second;
  });
  const auto floor = std::find_if(areas.begin(), areas.end(), [&](const auto& level) {
    return level.second >= kFloorShare * most->second;
  });
  return (static_cast<float>(floor->first) + 0.5f) * kFloorStep;
}

bool IsOnTheFloor(const SceneMesh& mesh, std::size_t triangle, float floor) {
  return std::abs(LowestOf(mesh, triangle) - floor) <= kOnTheFloor && IsLevel(mesh, triangle);
}

float ExactFloor(const SceneMesh& mesh, float floor) {
  double sum = 0.0;
  double area = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!IsOnTheFloor(mesh, t, floor)) continue;
    sum += AreaOf(mesh, t) * double{CentreOf(mesh, t).y()};
    area += AreaOf(mesh, t);
  }
  return area > 0.0 ? static_cast<float>(sum / area) : floor;
}

std::array<double, 3> MeanOf(const Image& image) {
  std::array<std::uint64_t, 3> sums{};
  for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
    for (std::size_t c = 0; c < 3; ++c) sums[c] += image.pixels[i + c];
  }
  const auto count = static_cast<double>(std::max<std::size_t>(1, image.pixels.size() / 4));
  return {static_cast<double>(sums[0]) / count, static_cast<double>(sums[1]) / count,
          static_cast<double>(sums[2]) / count};
}

std::array<double, 3> MeanOf(const SceneMesh& mesh, const Material& material) {
  std::array<double, 3> color = {kLightest, kLightest, kLightest};
  if (material.texture >= 0) {
    color = MeanOf(mesh.textures[static_cast<std::size_t>(material.texture)].image);
  }
  for (std::size_t c = 0; c < 3; ++c) color[c] *= material.base_color[c] / kLightest;
  return color;
}

std::uint32_t CopyVertex(std::uint32_t vertex, SceneMesh* mesh) {
  const auto copy = static_cast<std::uint32_t>(mesh->positions.size());
  mesh->positions.push_back(Eigen::Vector3f(mesh->positions[vertex]));
  mesh->uvs.push_back(Eigen::Vector2f(mesh->uvs[vertex]));
  mesh->colors.push_back(Rgb8(mesh->colors[vertex]));
  return copy;
}

void KeepTriangles(const std::vector<char>& kept, SceneMesh* mesh) {
  std::size_t end = 0;
  for (std::size_t t = 0; t < mesh->triangles.size(); ++t) {
    if (kept[t] == 0) continue;
    mesh->triangles[end] = mesh->triangles[t];
    mesh->triangle_materials[end] = mesh->triangle_materials[t];
    if (mesh->has_objects()) mesh->triangle_objects[end] = mesh->triangle_objects[t];
    ++end;
  }
  mesh->triangles.resize(end);
  mesh->triangle_materials.resize(end);
  if (mesh->has_objects()) mesh->triangle_objects.resize(end);
}

void AddTriangleLike(std::size_t triangle, const std::array<std::uint32_t, 3>& corners,
                     SceneMesh* mesh) {
  mesh->triangles.push_back(corners);
  mesh->triangle_materials.push_back(std::uint32_t{mesh->triangle_materials[triangle]});
  if (!mesh->has_objects()) return;
  mesh->triangle_objects.push_back(std::uint32_t{mesh->triangle_objects[triangle]});
}

}  // namespace bulletnav::sim
