// SPDX-License-Identifier: MIT
#include "sim/house/mesh_builder.h"

#include <algorithm>
#include <cmath>

#include "sim/base/check.h"
#include "sim/base/elementary.h"
#include "sim/math/pose.h"
#include "sim/math/rotation.h"

namespace bulletnav::sim {
namespace {

using Vec = MeshBuilder::Vec;
using Vec2 = MeshBuilder::Vec2;

constexpr float kFullTurn = static_cast<float>(2.0 * kPi);

/// Closed: the first point stands again at the end.
std::vector<Vec> Ring(const MeshBuilder::Oval& oval, int sides) {
  std::vector<Vec> ring;
  for (int i = 0; i <= sides; ++i) {
    const float angle = kFullTurn * static_cast<float>(i) / static_cast<float>(sides);
    ring.push_back(oval.centre +
                   Vec(oval.radii.x() * Cos(angle), 0.0f, -oval.radii.y() * Sin(angle)));
  }
  return ring;
}

float Cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

float SignedArea(std::span<const Vec2> polygon) {
  float twice = 0.0f;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    twice += Cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  }
  return 0.5f * twice;
}

bool Contains(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& p) {
  return Cross(b - a, p - a) >= 0.0f && Cross(c - b, p - b) >= 0.0f && Cross(a - c, p - c) >= 0.0f;
}

/// Ear clipping of a counter-clockwise simple polygon; triples of indices into it.
std::vector<std::array<std::size_t, 3>> Triangulate(std::span<const Vec2> polygon) {
  std::vector<std::size_t> left(polygon.size());
  for (std::size_t i = 0; i < left.size(); ++i) left[i] = i;
  std::vector<std::array<std::size_t, 3>> triangles;
  const auto is_ear = [&](std::size_t i) {
    const std::size_t n = left.size();
    const std::size_t a = left[(i + n - 1) % n];
    const std::size_t b = left[i];
    const std::size_t c = left[(i + 1) % n];
    if (Cross(polygon[b] - polygon[a], polygon[c] - polygon[b]) <= 0.0f) return false;
    return std::none_of(left.begin(), left.end(), [&](std::size_t p) {
      return p != a && p != b && p != c && Contains(polygon[a], polygon[b], polygon[c], polygon[p]);
    });
  };
  while (left.size() >= 3) {
    const std::size_t n = left.size();
    std::size_t ear = 0;
    while (ear < n && !is_ear(ear)) ++ear;
    if (ear == n) ear = 0;  // collinear rest
    // NOLINTNEXTLINE(clang-analyzer-core.DivideZero): n is at least 3
    triangles.push_back({left[(ear + n - 1) % n], left[ear], left[(ear + 1) % n]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  return triangles;
}

}  // namespace

MeshBuilder::Frame::Frame(MeshBuilder* builder, const Eigen::Affine3f& X_parent_this)
    : builder_(builder), saved_(builder->X_WL_) {
  builder_->X_WL_ = saved_ * X_parent_this;
}

MeshBuilder::Frame::Frame(MeshBuilder* builder, const Vec& at, float yaw)
    : Frame(builder, Eigen::Translation3f(at) * RotationAbout<float>(Vec::UnitY(), yaw)) {}

MeshBuilder::Frame::~Frame() {
  builder_->X_WL_ = saved_;
}

std::uint32_t MeshBuilder::MaterialOf(const Surface& surface) {
  const auto next = static_cast<std::uint32_t>(mesh_.materials.size());
  const auto [place, is_new] =
      materials_.try_emplace({std::string(surface.material), surface.tint}, next);
  if (is_new) mesh_.materials.push_back({std::string(surface.material), surface.tint, -1});
  return place->second;
}

std::uint32_t MeshBuilder::AddVertex(const Vec& local, const Vec2& uv) {
  mesh_.positions.push_back(X_WL_ * local);
  mesh_.uvs.push_back(uv);
  mesh_.colors.push_back(kWhite);
  return static_cast<std::uint32_t>(mesh_.positions.size()) - 1;
}

void MeshBuilder::AddTriangle(std::uint32_t material, std::uint32_t a, std::uint32_t b,
                              std::uint32_t c) {
  const Vec u = mesh_.positions[b] - mesh_.positions[a];
  const Vec v = mesh_.positions[c] - mesh_.positions[a];
  if (u.cross(v).norm() < 1e-9f) return;  // the tip of a cone, the pole of a ball
  mesh_.triangles.push_back({a, b, c});
  mesh_.triangle_materials.push_back(material);
  mesh_.triangle_objects.push_back(Object());
  glows_.push_back(glow_);
}

void MeshBuilder::Face(const Surface& surface, std::span<const Vec> corners,
                       std::span<const Vec2> metres) {
  const std::uint32_t material = MaterialOf(surface);
  const float scale = 1.0f / FindMaterial(surface.material).metres;
  std::vector<std::uint32_t> v;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    v.push_back(AddVertex(corners[i], metres[i] * scale));
  }
  for (std::size_t i = 2; i < v.size(); ++i) AddTriangle(material, v[0], v[i - 1], v[i]);
}

void MeshBuilder::Quad(const Surface& surface, const Vec& a, const Vec& b, const Vec& c,
                       const Vec& d, const Vec& u) {
  const Vec normal = (b - a).cross(d - a).normalized();
  Vec right = u;
  if (right.isZero()) {
    // Pictures stand upright on walls and run along x on level faces.
    right = std::abs(normal.y()) > 0.9f ? Vec::UnitX() : Vec(Vec::UnitY().cross(normal));
  }
  right = (right - right.dot(normal) * normal).normalized();
  const Vec up = normal.cross(right);
  const std::array corners = {a, b, c, d};
  std::array<Vec2, 4> metres;
  for (std::size_t i = 0; i < 4; ++i) {
    metres[i] = Vec2(corners[i].dot(right), -corners[i].dot(up));
  }
  Face(surface, corners, metres);
}

void MeshBuilder::Picture(const Surface& surface, const Vec& a, const Vec& b, const Vec& c,
                          const Vec& d, const Eigen::AlignedBox2f& part) {
  const float size = FindMaterial(surface.material).metres;
  const Vec2 low = part.min() * size;
  const Vec2 high = part.max() * size;
  // The picture's rows run down.
  Face(surface, std::array{a, b, c, d},
       std::array{Vec2(low.x(), size - low.y()), Vec2(high.x(), size - low.y()),
                  Vec2(high.x(), size - high.y()), Vec2(low.x(), size - high.y())});
}

void MeshBuilder::Triangle(const Surface& surface, const Vec& a, const Vec& b, const Vec& c) {
  const Vec right = (b - a).normalized();
  const Vec up = (b - a).cross(c - a).normalized().cross(right);
  const auto flat = [&](const Vec& p) {
    return Vec2((p - a).dot(right), -(p - a).dot(up));
  };
  Face(surface, std::array{a, b, c}, std::array{flat(a), flat(b), flat(c)});
}

void MeshBuilder::Box(const Surface& surface, const Vec& low, const Vec& high) {
  const auto at = [&](int x, int y, int z) {
    return Vec(x ? high.x() : low.x(), y ? high.y() : low.y(), z ? high.z() : low.z());
  };
  Hexahedron(surface, at);
}

template <class Corner>
void MeshBuilder::Hexahedron(const Surface& surface, const Corner& at) {
  Quad(surface, at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1));  // front
  Quad(surface, at(1, 0, 0), at(0, 0, 0), at(0, 1, 0), at(1, 1, 0));  // back
  Quad(surface, at(1, 0, 1), at(1, 0, 0), at(1, 1, 0), at(1, 1, 1));  // right
  Quad(surface, at(0, 0, 0), at(0, 0, 1), at(0, 1, 1), at(0, 1, 0));  // left
  Quad(surface, at(0, 1, 1), at(1, 1, 1), at(1, 1, 0), at(0, 1, 0));  // top
  Quad(surface, at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1));  // bottom
}

void MeshBuilder::Block(const Surface& surface, const Vec& centre_bottom, const Vec& size) {
  const Vec half(0.5f * size.x(), 0.0f, 0.5f * size.z());
  Box(surface, centre_bottom - half, centre_bottom + half + Vec(0, size.y(), 0));
}

void MeshBuilder::RoundedBox(const Surface& surface, const Vec& low, const Vec& high,
                             float radius) {
  const Vec size = high - low;
  // The cut corners of the smallest outline must not meet.
  const float r = std::min({radius, size.x() / 2.7f, size.z() / 2.7f, size.y()});
  // Outlines with cut corners, drawing in towards the top.
  const auto outline = [&](float inset, float y) {
    const float x0 = low.x() + inset;
    const float x1 = high.x() - inset;
    const float z0 = low.z() + inset;
    const float z1 = high.z() - inset;
    const float cut = std::max(0.0f, 0.6f * r - 0.3f * inset);
    std::vector<Vec> ring = {{x0 + cut, y, z1}, {x1 - cut, y, z1}, {x1, y, z1 - cut},
                             {x1, y, z0 + cut}, {x1 - cut, y, z0}, {x0 + cut, y, z0},
                             {x0, y, z0 + cut}, {x0, y, z1 - cut}};
    ring.push_back(ring.front());
    return ring;
  };
  const std::vector<std::vector<Vec>> rings = {outline(0.0f, low.y()), outline(0.0f, high.y() - r),
                                               outline(0.3f * r, high.y() - 0.3f * r),
                                               outline(r, high.y())};
  Tube(surface, rings);
  const std::vector<Vec> top(rings.back().begin(), rings.back().end() - 1);
  std::vector<Vec2> metres;
  metres.reserve(top.size());
  for (const Vec& p : top) metres.emplace_back(p.x(), p.z());
  Face(surface, top, metres);
}

void MeshBuilder::TaperedBox(const Surface& surface, const Vec& low, const Vec2& low_size,
                             const Vec& high, const Vec2& high_size) {
  const auto at = [&](int x, int y, int z) {
    const Vec2& size = y ? high_size : low_size;
    return Vec((y ? high : low) + 0.5f * Vec(x ? size.x() : -size.x(), 0.0f,  //
                                             z ? size.y() : -size.y()));
  };
  Hexahedron(surface, at);
}

void MeshBuilder::Tube(const Surface& surface, const std::vector<std::vector<Vec>>& rings) {
  const std::uint32_t material = MaterialOf(surface);
  const float scale = 1.0f / FindMaterial(surface.material).metres;
  float along = 0.0f;
  std::vector<std::uint32_t> below;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    if (r > 0) along += (rings[r][0] - rings[r - 1][0]).norm();
    float around = 0.0f;
    std::vector<std::uint32_t> here;
    for (std::size_t i = 0; i < rings[r].size(); ++i) {
      if (i > 0) around += (rings[r][i] - rings[r][i - 1]).norm();
      here.push_back(AddVertex(rings[r][i], Vec2(around, -along) * scale));
    }
    for (std::size_t i = 1; r > 0 && i < here.size(); ++i) {
      AddTriangle(material, below[i - 1], below[i], here[i]);
      AddTriangle(material, below[i - 1], here[i], here[i - 1]);
    }
    below = std::move(here);
  }
}

void MeshBuilder::Cylinder(const Surface& surface, const Vec& bottom, float radius, float height,
                           int sides) {
  Cone(surface, bottom, radius, radius, height, sides);
}

void MeshBuilder::Cone(const Surface& surface, const Vec& bottom, float bottom_radius,
                       float top_radius, float height, int sides) {
  Lathe(surface, bottom,
        std::array{Vec2(0, 0), Vec2(bottom_radius, 0), Vec2(top_radius, height), Vec2(0, height)},
        sides);
}

void MeshBuilder::Bar(const Surface& surface, const Vec& a, const Vec& b, float radius, int sides) {
  const Vec axis = b - a;
  if (axis.norm() < 1e-6f) return;
  const Eigen::Quaternionf turn = Eigen::Quaternionf::FromTwoVectors(Vec::UnitY(), axis);
  const Frame frame(this, Eigen::Translation3f(a) * turn);
  Cylinder(surface, Vec::Zero(), radius, axis.norm(), sides);
}

void MeshBuilder::Lathe(const Surface& surface, const Vec& at, std::span<const Vec2> profile,
                        int sides) {
  std::vector<Oval> ovals;
  ovals.reserve(profile.size());
  for (const Vec2& p : profile) {
    ovals.push_back({at + Vec(0, p.y(), 0), Vec2(p.x(), p.x())});
  }
  Loft(surface, ovals, sides);
}

void MeshBuilder::Loft(const Surface& surface, std::span<const Oval> ovals, int sides) {
  std::vector<std::vector<Vec>> rings;
  for (const Oval& oval : ovals) rings.push_back(Ring(oval, sides));
  // Vertices are not shared across the profile's corners, so that light can differ there.
  for (std::size_t i = 1; i < rings.size(); ++i) {
    if (std::abs(ovals[i].centre.y() - ovals[i - 1].centre.y()) < 1e-6f) {
      LevelBand(surface, rings[i - 1], rings[i]);
    } else {
      Tube(surface, {rings[i - 1], rings[i]});
    }
  }
}

void MeshBuilder::LevelBand(const Surface& surface, const std::vector<Vec>& outer,
                            const std::vector<Vec>& inner) {
  const std::uint32_t material = MaterialOf(surface);
  const float scale = 1.0f / FindMaterial(surface.material).metres;
  const auto add = [&](const Vec& p) {
    return AddVertex(p, Vec2(p.x(), p.z()) * scale);
  };
  for (std::size_t i = 1; i < outer.size(); ++i) {
    const std::uint32_t a = add(outer[i - 1]);
    const std::uint32_t b = add(outer[i]);
    const std::uint32_t c = add(inner[i]);
    AddTriangle(material, a, b, c);
    AddTriangle(material, a, c, add(inner[i - 1]));
  }
}

void MeshBuilder::Ball(const Surface& surface, const Vec& centre, const Vec& radii, int sides) {
  const int bands = std::max(3, sides / 2);
  std::vector<std::vector<Vec>> rings;
  for (int i = 0; i <= bands; ++i) {
    const float angle = 0.5f * kFullTurn * static_cast<float>(i) / static_cast<float>(bands);
    const Vec2 level = Vec2(radii.x(), radii.z()) * Sin(angle);
    rings.push_back(Ring({centre - Vec(0, radii.y() * Cos(angle), 0), level}, sides));
  }
  Tube(surface, rings);
}

void MeshBuilder::Polygon(const Surface& surface, std::span<const Vec2> polygon, float y,
                          bool faces_up) {
  // With z down the page, (x, z) counter-clockwise faces down in (x, y, z).
  std::vector<Vec2> points(polygon.begin(), polygon.end());
  if (SignedArea(points) < 0.0f) std::reverse(points.begin(), points.end());
  const std::uint32_t material = MaterialOf(surface);
  const float scale = 1.0f / FindMaterial(surface.material).metres;
  std::vector<std::uint32_t> v;
  v.reserve(points.size());
  for (const Vec2& p : points) v.push_back(AddVertex(Vec(p.x(), y, p.y()), p * scale));
  for (const auto& [a, b, c] : Triangulate(points)) {
    if (faces_up) {
      AddTriangle(material, v[a], v[c], v[b]);
    } else {
      AddTriangle(material, v[a], v[b], v[c]);
    }
  }
}

void MeshBuilder::Prism(const Surface& surface, std::span<const Vec2> polygon, float low,
                        float high) {
  std::vector<Vec2> points(polygon.begin(), polygon.end());
  if (SignedArea(points) < 0.0f) std::reverse(points.begin(), points.end());
  Polygon(surface, points, high, true);
  Polygon(surface, points, low, false);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2& p = points[i];
    const Vec2& q = points[(i + 1) % points.size()];
    Quad(surface, Vec(q.x(), low, q.y()), Vec(p.x(), low, p.y()), Vec(p.x(), high, p.y()),
         Vec(q.x(), high, q.y()));
  }
}

void MeshBuilder::Drape(const Surface& surface, const Vec& a, const Vec& b, float drop,
                        float fold_depth, int folds) {
  const Vec along = (b - a) / static_cast<float>(2 * folds);
  const Vec out = along.cross(Vec::UnitY()).normalized() * fold_depth;
  std::vector<Vec> upper;
  std::vector<Vec> lower;
  for (int i = 0; i <= 2 * folds; ++i) {
    const Vec p = a + static_cast<float>(i) * along + (i % 2 == 0 ? 0.5f : -0.5f) * out;
    upper.push_back(p);
    lower.push_back(p - Vec(0, drop, 0));
  }
  Tube(surface, {lower, upper});
}

void MeshBuilder::Append(const MeshBuilder& part) {
  const auto base = static_cast<std::uint32_t>(mesh_.positions.size());
  for (const Vec& p : part.mesh_.positions) mesh_.positions.push_back(X_WL_ * p);
  mesh_.uvs.insert(mesh_.uvs.end(), part.mesh_.uvs.begin(), part.mesh_.uvs.end());
  mesh_.colors.insert(mesh_.colors.end(), part.mesh_.colors.begin(), part.mesh_.colors.end());
  std::vector<std::uint32_t> material(part.mesh_.materials.size());
  for (const auto& [key, index] : part.materials_) {
    material[index] = MaterialOf({key.first, key.second});
  }
  for (std::size_t t = 0; t < part.mesh_.triangles.size(); ++t) {
    const auto& [a, b, c] = part.mesh_.triangles[t];
    mesh_.triangles.push_back({base + a, base + b, base + c});
    mesh_.triangle_materials.push_back(material[part.mesh_.triangle_materials[t]]);
    mesh_.triangle_objects.push_back(Object());
    glows_.push_back(part.glows_[t]);
  }
}

std::uint32_t MeshBuilder::Object() const {
  return mesh_.objects.empty() ? 0 : static_cast<std::uint32_t>(mesh_.objects.size()) - 1;
}

const SceneObject& MeshBuilder::BeginObject(std::string_view category, std::string_view room) {
  if (mesh_.objects.empty()) mesh_.objects.emplace_back();
  const std::string text(category);
  const int number = ++objects_of_category_[text];
  mesh_.objects.push_back({text, text + "_" + std::to_string(number), std::string(room)});
  return mesh_.objects.back();
}

SceneMesh MeshBuilder::Finish(TextureCache* cache) {
  SceneMesh mesh = mesh_;
  if (mesh.objects.empty()) mesh.triangle_objects.clear();
  std::map<std::string, int> texture_of_name;
  for (Material& material : mesh.materials) {
    const auto next = static_cast<int>(mesh.textures.size());
    const auto [place, is_new] = texture_of_name.try_emplace(material.name, next);
    if (is_new) mesh.textures.push_back({material.name, cache->Get(material.name)});
    material.texture = place->second;
  }
  return mesh;
}

}  // namespace bulletnav::sim
