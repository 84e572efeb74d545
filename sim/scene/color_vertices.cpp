// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <map>

#include "sim/scene/low_poly.h"
#include "sim/scene/mesh_measures.h"
#include "sim/scene/refine.h"

namespace bulletnav::sim {
namespace {

constexpr int kLightest = 255;

/// Pixels of each material's texture to a metre, on the whole; 0 without a texture.
std::vector<double> DensitiesOf(const SceneMesh& mesh) {
  std::vector<double> areas(mesh.materials.size());
  std::vector<double> pixels(mesh.materials.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::uint32_t material = mesh.triangle_materials[t];
    const int texture = mesh.materials[material].texture;
    if (texture < 0) continue;
    const Image& image = mesh.textures[static_cast<std::size_t>(texture)].image;
    const auto& corners = mesh.triangles[t];
    const Eigen::Vector2d a = mesh.uvs[corners[0]].cast<double>();
    const Eigen::Vector2d ab = mesh.uvs[corners[1]].cast<double>() - a;
    const Eigen::Vector2d ac = mesh.uvs[corners[2]].cast<double>() - a;
    pixels[material] +=
        0.5 * std::abs(ab.x() * ac.y() - ab.y() * ac.x()) * image.width * image.height;
    areas[material] += AreaOf(mesh, t);
  }
  std::vector<double> densities;
  for (std::size_t m = 0; m < areas.size(); ++m) {
    densities.push_back(areas[m] > 0.0 ? std::sqrt(pixels[m] / areas[m]) : 0.0);
  }
  return densities;
}

/// Paints vertices by what their triangles' materials show there.
class VertexPainter {
 public:
  VertexPainter(double spacing, SceneMesh* mesh) : mesh_(mesh) {
    const std::vector<double> densities = DensitiesOf(*mesh);
    for (std::size_t m = 0; m < densities.size(); ++m) {
      const int texture = mesh->materials[m].texture;
      pictures_.emplace_back();
      if (texture < 0) continue;
      const Image& image = mesh->textures[static_cast<std::size_t>(texture)].image;
      const double shrink = std::max(1.0, densities[m] * spacing);
      pictures_.back() =
          Resize(image, std::max(1, static_cast<int>(std::lround(image.width / shrink))),
                 std::max(1, static_cast<int>(std::lround(image.height / shrink))));
    }
  }

  void Run() {
    const std::size_t count = mesh_->positions.size();
    painted_by_.assign(count, kNone);
    for (std::size_t t = 0; t < mesh_->triangles.size(); ++t) {
      for (std::uint32_t& corner : mesh_->triangles[t]) {
        corner = Paint(corner, mesh_->triangle_materials[t]);
      }
      mesh_->triangle_materials[t] = 0;
    }
    mesh_->materials = {{"colours of vertices", kWhite, -1}};
    mesh_->textures.clear();
  }

 private:
  static constexpr std::uint32_t kNone = 0xffffffffu;

  /// The vertex, or a copy of it where another material has painted it.
  std::uint32_t Paint(std::uint32_t vertex, std::uint32_t material) {
    if (painted_by_[vertex] == material) return vertex;
    if (painted_by_[vertex] == kNone) {
      painted_by_[vertex] = material;
      unpainted_.try_emplace(vertex, mesh_->colors[vertex]);
      mesh_->colors[vertex] = ColorOf(vertex, material);
      return vertex;
    }
    const auto [found, is_new] = copies_.try_emplace({vertex, material}, 0);
    if (is_new) {
      found->second = CopyVertex(vertex, mesh_);
      mesh_->colors[found->second] = unpainted_.at(vertex);
      mesh_->colors[found->second] = ColorOf(found->second, material);
    }
    return found->second;
  }

  Rgb8 ColorOf(std::uint32_t vertex, std::uint32_t material) const {
    Rgb8 seen = {kLightest, kLightest, kLightest};
    const Image& picture = pictures_[material];
    if (!picture.pixels.empty()) {
      const Eigen::Vector2f& uv = mesh_->uvs[vertex];
      const std::uint8_t* pixel =
          picture.at(Wrapped(uv.x(), picture.width), Wrapped(uv.y(), picture.height));
      std::copy_n(pixel, seen.size(), seen.begin());
    }
    for (std::size_t c = 0; c < seen.size(); ++c) {
      const int product =
          seen[c] * mesh_->materials[material].base_color[c] * mesh_->colors[vertex][c];
      seen[c] = static_cast<std::uint8_t>(product / (kLightest * kLightest));
    }
    return seen;
  }

  static int Wrapped(float coordinate, int size) {
    const double part = double{coordinate} - std::floor(double{coordinate});
    return std::clamp(static_cast<int>(part * size), 0, size - 1);
  }

  SceneMesh* mesh_;
  std::vector<Image> pictures_;            // by material; of about a pixel a vertex
  std::vector<std::uint32_t> painted_by_;  // by vertex: the material
  std::map<std::uint32_t, Rgb8> unpainted_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> copies_;
};

}  // namespace

void PaintVertices(double spacing, SceneMesh* mesh) {
  if (spacing <= 0.0) return;
  RefineTo(spacing, mesh);
  VertexPainter(spacing, mesh).Run();
}

}  // namespace bulletnav::sim
