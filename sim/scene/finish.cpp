// SPDX-License-Identifier: MIT
#include "sim/scene/finish.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>

#include "sim/base/error.h"
#include "sim/scene/mesh_measures.h"

namespace bulletnav::sim {
namespace {

constexpr float kOverhead = 2.0f;  // metres above the floor
constexpr double kMiddleGrey = 127.5;
constexpr double kLightest = 255.0;
constexpr int kMostShrunk = 1024;
constexpr const char* kBlankFloor = "blank floor";
constexpr Rgb8 kNearlyBlack = {10, 10, 10};
// Parts of red, green and blue in grey (Rec. 709).
constexpr std::array<double, 3> kGreyParts = {0.2126, 0.7152, 0.0722};

using Color = std::array<double, 3>;

std::uint8_t ToByte(double value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, kLightest)));
}

Rgb8 ToRgb8(const Color& color) {
  return {ToByte(color[0]), ToByte(color[1]), ToByte(color[2])};
}

double GreyOf(const Color& color) {
  return kGreyParts[0] * color[0] + kGreyParts[1] * color[1] + kGreyParts[2] * color[2];
}

double GreyOf(const Rgb8& color) {
  return GreyOf(Color{1.0 * color[0], 1.0 * color[1], 1.0 * color[2]});
}

/// Whether a triangle is level and more than a door's height above the floor.
std::vector<char> Overhead(const SceneMesh& mesh) {
  const float overhead = FloorHeight(mesh) + kOverhead;
  std::vector<char> is_overhead;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    is_overhead.push_back(LowestOf(mesh, t) >= overhead && IsLevel(mesh, t) ? 1 : 0);
  }
  return is_overhead;
}

void RemoveCeiling(SceneMesh* mesh) {
  std::vector<char> kept = Overhead(*mesh);
  for (char& one : kept) one = one == 0 ? 1 : 0;
  if (std::count(kept.begin(), kept.end(), 1) > 0) KeepTriangles(kept, mesh);
}

void BlackenOverhead(SceneMesh* mesh) {
  const std::vector<char> is_overhead = Overhead(*mesh);
  const auto black = static_cast<std::uint32_t>(mesh->materials.size());
  mesh->materials.push_back({"black overhead", kNearlyBlack, -1});
  for (std::size_t t = 0; t < is_overhead.size(); ++t) {
    if (is_overhead[t] != 0) mesh->triangle_materials[t] = black;
  }
}

bool IsWhite(const Rgb8& color) {
  return color == Rgb8{kWhite};
}

/// Whether surfaces have their colours from vertices alone, as a scan without pictures: one colour
/// in all materials, and others in the vertices. Elsewhere vertices carry light.
bool IsColoredByVertices(const SceneMesh& mesh) {
  if (!mesh.textures.empty() || mesh.triangles.empty()) return false;
  const auto color_of = [&](std::uint32_t material) {
    return mesh.materials[material].base_color;
  };
  const Rgb8 first = color_of(mesh.triangle_materials.front());
  return std::all_of(mesh.triangle_materials.begin(), mesh.triangle_materials.end(),
                     [&](std::uint32_t material) {
                       return color_of(material) == first;
                     }) &&
         !std::all_of(mesh.colors.begin(), mesh.colors.end(), IsWhite);
}

/// Puts what colours materials have into the vertices, so that those are white.
void MoveColorsToVertices(SceneMesh* mesh) {
  const Rgb8 base = mesh->materials[mesh->triangle_materials.front()].base_color;
  for (Rgb8& color : mesh->colors) {
    for (std::size_t c = 0; c < 3; ++c) color[c] = ToByte(color[c] * base[c] / kLightest);
  }
  for (Material& material : mesh->materials) material.base_color = kWhite;
}

/// A blank floor where vertices give the colours: of their mean's grey.
void BlankFloorOfVertices(SceneMesh* mesh) {
  const float floor = FloorHeight(*mesh);
  const auto blank = static_cast<std::uint32_t>(mesh->materials.size());
  double greys = 0.0;
  double area = 0.0;
  for (std::size_t t = 0; t < mesh->triangles.size(); ++t) {
    if (!IsOnTheFloor(*mesh, t, floor)) continue;
    const double of_one = AreaOf(*mesh, t);
    area += of_one;
    for (std::uint32_t& vertex : mesh->triangles[t]) {
      const Rgb8& color = mesh->colors[vertex];
      greys += of_one / 3.0 * GreyOf(color);
      vertex = CopyVertex(vertex, mesh);  // walls keep theirs
      mesh->colors.back() = kWhite;
    }
    mesh->triangle_materials[t] = blank;
  }
  if (area <= 0.0) return;
  const double grey = greys / area;
  mesh->materials.push_back({kBlankFloor, ToRgb8({grey, grey, grey}), -1});
}

void BlankFloor(SceneMesh* mesh) {
  const float floor = FloorHeight(*mesh);
  std::map<std::uint32_t, std::uint32_t> blanks;  // by material
  for (std::size_t t = 0; t < mesh->triangles.size(); ++t) {
    if (!IsOnTheFloor(*mesh, t, floor)) continue;
    std::uint32_t& material = mesh->triangle_materials[t];
    const auto [found, is_new] =
        blanks.try_emplace(material, static_cast<std::uint32_t>(mesh->materials.size()));
    if (is_new) {
      const double grey = GreyOf(MeanOf(*mesh, mesh->materials[material]));
      mesh->materials.push_back({kBlankFloor, ToRgb8({grey, grey, grey}), -1});
    }
    material = found->second;
  }
}

/// What a material covers.
struct Cover {
  double area = 0.0;  // m2
  double upright = 0.0;
  float lowest = HUGE_VALF;  // metres
  float highest = -HUGE_VALF;

  bool IsWall(float floor) const {
    constexpr double kUprightPart = 0.9;
    constexpr double kLeastArea = 5.0;
    constexpr float kFoot = 0.5f;
    constexpr float kHead = 2.2f;  // above doors and wardrobes
    return upright >= std::max(kLeastArea, kUprightPart * area) && lowest < floor + kFoot &&
           highest > floor + kHead;
  }
};

void BlankWalls(SceneMesh* mesh) {
  constexpr float kUpright = 0.1f;  // vertical part of the normal, at most
  std::vector<Cover> covers(mesh->materials.size());
  for (std::size_t t = 0; t < mesh->triangles.size(); ++t) {
    Cover& cover = covers[mesh->triangle_materials[t]];
    const Eigen::Vector3f normal = NormalOf(*mesh, t);
    const double area = AreaOf(*mesh, t);
    cover.area += area;
    if (std::abs(normal.y()) <= kUpright * normal.norm()) cover.upright += area;
    cover.lowest = std::min(cover.lowest, LowestOf(*mesh, t));
    cover.highest = std::max(cover.highest, HighestOf(*mesh, t));
  }
  const float floor = FloorHeight(*mesh);
  for (std::size_t m = 0; m < covers.size(); ++m) {
    if (covers[m].IsWall(floor)) mesh->materials[m] = {"blank wall", kWhite, -1};
  }
}

void Recolor(Surfaces surfaces, SceneMesh* mesh) {
  if (surfaces == Surfaces::kOriginal) return;
  for (Material& material : mesh->materials) {
    const bool keeps = surfaces == Surfaces::kFlat ||
                       (surfaces == Surfaces::kAllWhite && material.name == kBlankFloor);
    material.base_color = keeps ? ToRgb8(MeanOf(*mesh, material)) : Rgb8{kWhite};
    material.texture = -1;
  }
  mesh->textures.clear();
  if (surfaces != Surfaces::kAllWhite) return;
  for (Rgb8& color : mesh->colors) {
    const double grey = GreyOf(color);
    color = ToRgb8({grey, grey, grey});
  }
}

/// Columns or rows from `begin` to before `end`.
struct Span {
  int begin = 0;
  int end = 0;
  int size() const { return end - begin; }
};

/// The `i`-th block of `count` along a side of `size` pixels; the last takes what is left over.
Span BlockOf(int i, int count, int shrink, int size) {
  return {i * shrink, i + 1 == count ? size : (i + 1) * shrink};
}

/// Mean of a block's pixels, rounded.
std::array<std::uint8_t, 4> MeanOfBlock(const Image& image, Span columns, Span rows) {
  std::array<std::int64_t, 4> sums{};
  for (int v = rows.begin; v < rows.end; ++v) {
    for (int u = columns.begin; u < columns.end; ++u) {
      for (std::size_t c = 0; c < sums.size(); ++c) sums[c] += image.at(u, v)[c];
    }
  }
  const std::int64_t count = std::int64_t{columns.size()} * rows.size();
  std::array<std::uint8_t, 4> mean{};
  for (std::size_t c = 0; c < mean.size(); ++c) {
    mean[c] = static_cast<std::uint8_t>((sums[c] + count / 2) / count);
  }
  return mean;
}

/// Means of blocks of `shrink` x `shrink` pixels.
Image Shrunk(const Image& image, int shrink) {
  Image small(std::max(1, image.width / shrink), std::max(1, image.height / shrink), 4);
  for (int y = 0; y < small.height; ++y) {
    const Span rows = BlockOf(y, small.height, shrink, image.height);
    for (int x = 0; x < small.width; ++x) {
      const Span columns = BlockOf(x, small.width, shrink, image.width);
      const auto mean = MeanOfBlock(image, columns, rows);
      std::copy(mean.begin(), mean.end(), small.at(x, y));
    }
  }
  return small;
}

/// What exposure, contrast, saturation and tint make of a colour.
Rgb8 Developed(const Finish& finish, const std::uint8_t* rgb) {
  Color color{};
  for (std::size_t c = 0; c < 3; ++c) color[c] = rgb[c] * finish.exposure * finish.tint[c];
  const double grey = GreyOf(color);
  for (double& value : color) {
    value = grey + (value - grey) * finish.saturation;
    value = (value - kMiddleGrey) * finish.contrast + kMiddleGrey;
  }
  return ToRgb8(color);
}

bool Develops(const Finish& finish) {
  const Finish none;
  return finish.exposure != none.exposure || finish.contrast != none.contrast ||
         finish.saturation != none.saturation || finish.tint != none.tint;
}

/// Where vertices give the colours: theirs, but of surfaces that a finish has given another.
void DevelopVertices(const Finish& finish, SceneMesh* mesh) {
  std::vector<char> is_developed(mesh->colors.size(), 0);
  for (std::size_t t = 0; t < mesh->triangles.size(); ++t) {
    if (!IsWhite(mesh->materials[mesh->triangle_materials[t]].base_color)) continue;
    for (const std::uint32_t vertex : mesh->triangles[t]) is_developed[vertex] = 1;
  }
  for (std::size_t v = 0; v < mesh->colors.size(); ++v) {
    if (is_developed[v] != 0) mesh->colors[v] = Developed(finish, mesh->colors[v].data());
  }
  for (Material& material : mesh->materials) {
    if (IsWhite(material.base_color)) continue;
    material.base_color = Developed(finish, material.base_color.data());
  }
}

/// A material's own colour where it has no texture, else the texture's: not both.
void DevelopMaterials(const Finish& finish, SceneMesh* mesh) {
  for (Material& material : mesh->materials) {
    if (material.texture < 0) material.base_color = Developed(finish, material.base_color.data());
  }
  for (Texture& texture : mesh->textures) {
    std::vector<std::uint8_t>& pixels = texture.image.pixels;
    for (std::size_t i = 0; i < pixels.size(); i += 4) {
      const Rgb8 color = Developed(finish, &pixels[i]);
      std::copy(color.begin(), color.end(), &pixels[i]);
    }
  }
}

}  // namespace

void Finish::Validate() const {
  if (texture_shrink < 1 || texture_shrink > kMostShrunk) {
    throw Error("texture_shrink must lie between 1 and 1024");
  }
  const auto is_factor = [](double value) {
    constexpr double kMost = 10.0;
    return value >= 0.0 && value <= kMost;
  };
  if (!is_factor(exposure) || !is_factor(contrast) || !is_factor(saturation) ||
      !std::all_of(tint.begin(), tint.end(), is_factor)) {
    throw Error("exposure, contrast, saturation and tint must lie between 0 and 10");
  }
  repaint.Validate();
  damage.Validate();
}

void ApplyFinish(const Finish& finish, SceneMesh* mesh) {
  finish.Validate();
  if (finish == Finish{}) return;
  const bool by_vertices = IsColoredByVertices(*mesh);
  if (by_vertices) MoveColorsToVertices(mesh);
  ApplyRepaint(finish.repaint, mesh);
  if (!finish.ceiling) RemoveCeiling(mesh);
  if (finish.blank_floor && by_vertices) BlankFloorOfVertices(mesh);
  if (finish.blank_floor && !by_vertices) BlankFloor(mesh);
  if (finish.blank_walls) BlankWalls(mesh);
  Recolor(finish.surfaces, mesh);
  if (finish.black_overhead) BlackenOverhead(mesh);
  if (!finish.baked_light) std::fill(mesh->colors.begin(), mesh->colors.end(), kWhite);
  if (finish.texture_shrink > 1) {
    for (Texture& texture : mesh->textures) {
      texture.image = Shrunk(texture.image, finish.texture_shrink);
    }
  }
  if (Develops(finish) && by_vertices) DevelopVertices(finish, mesh);
  if (Develops(finish) && !by_vertices) DevelopMaterials(finish, mesh);
  mesh->back_faces = finish.back_faces;
  mesh->levels_of_detail = finish.levels_of_detail;
}

}  // namespace bulletnav::sim
