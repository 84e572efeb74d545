// SPDX-License-Identifier: MIT
#include "sim/house/lighting.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>
#include <unordered_map>

#include "sim/base/elementary.h"
#include "sim/house/hemisphere.h"
#include "sim/house/light_sources.h"
#include "sim/house/refine.h"
#include "sim/render/cpu/ray_tracer.h"

namespace bulletnav::sim {
namespace {

using Vec = Eigen::Vector3f;

constexpr int kPackets = 2;              // of 16 directions a gathering
constexpr std::size_t kDirections = 32;  // all of them
constexpr float kLift = 0.004f;          // sample points stand off their surface, metres
constexpr float kInward = 0.06f;         // and are drawn in towards their triangle's middle
constexpr float kNearBackFace = 0.12f;   // a back face this near: the point is inside something
constexpr float kAmbientReach = 1.2f;    // occluders farther than this do not dim it, metres
constexpr float kBounce = 1.25f;         // makes up for the bounces left out
constexpr float kExposure = 2.3f;
constexpr float kDarkest = 0.22f;  // of display brightness
constexpr int kRefineRounds = 40;
constexpr float kFiner = 0.6f;

std::vector<std::array<Vec, 3>> Corners(const SceneMesh& mesh) {
  std::vector<std::array<Vec, 3>> corners;
  for (const auto& [a, b, c] : mesh.triangles) {
    corners.push_back({mesh.positions[a], mesh.positions[b], mesh.positions[c]});
  }
  return corners;
}

Vec NormalOf(const std::array<Vec, 3>& t) {
  return (t[1] - t[0]).cross(t[2] - t[0]).normalized();
}

/// Mean colour of each material, linear enough for one bounce.
std::vector<Vec> Albedos(const SceneMesh& mesh) {
  std::vector<Vec> means;
  for (const Texture& texture : mesh.textures) {
    const Image one = Resize(texture.image, 1, 1);
    means.emplace_back(one.pixels[0], one.pixels[1], one.pixels[2]);
  }
  std::vector<Vec> albedos;
  for (const Material& material : mesh.materials) {
    Vec color(material.base_color[0], material.base_color[1], material.base_color[2]);
    if (material.texture >= 0) {
      color = color.cwiseProduct(means[static_cast<std::size_t>(material.texture)]) / 255.0f;
    }
    albedos.push_back((color / 255.0f).array().pow(1.8f));
  }
  return albedos;
}

/// A place and its normal, to the bit.
using PlaceKey = std::array<std::uint32_t, 6>;

struct PlaceHash {
  std::size_t operator()(const PlaceKey& key) const {
    std::uint64_t hash = 0;
    for (const std::uint32_t word : key) {
      hash = (hash ^ word) * 0x9e3779b97f4a7c15ULL;
      hash ^= hash >> 29;
    }
    return hash;
  }
};

/// Light at the vertices of a mesh whose vertices are not shared between faces of other directions.
class Baker {
 public:
  Baker(SceneMesh* mesh, std::span<const Glow> glows, const LightSpec& spec)
      : mesh_(*mesh), spec_(spec) {
    for (const Glow glow : glows) glow_.push_back(static_cast<int>(glow));
    sources_.emplace(mesh_, glow_, spec.lamp_power);
  }

  void Bake() {
    coarse_.emplace(Corners(mesh_));
    Refine();
    sketches_.clear();
    const std::vector<Vec> direct = DirectLight();
    coarse_.reset();
    WriteColors(direct, GatheredLight(direct));
  }

 private:
  /// Where a vertex is sampled from: one of its triangles.
  struct Place {
    Vec point = Vec::Zero();
    Vec normal = Vec::Zero();
  };

  Place PlaceIn(std::size_t triangle, std::size_t k) const {
    const auto& t = mesh_.triangles[triangle];
    const std::array corners = {mesh_.positions[t[0]], mesh_.positions[t[1]],
                                mesh_.positions[t[2]]};
    const Vec middle = (corners[0] + corners[1] + corners[2]) / 3.0f;
    const Vec way = middle - corners[k];
    const float inward = std::min(kInward, 0.5f * way.norm());
    const Vec normal = NormalOf(corners);
    return {corners[k] + inward * way.normalized() + kLift * normal, normal};
  }

  /// Edges are halved if long, or if the light in their middle is not the mean of their ends'.
  void Refine() {
    for (int round = 0; round < kRefineRounds; ++round) {
      const std::size_t before = mesh_.triangles.size();
      if (static_cast<int>(before) > spec_.max_triangles) return;
      FindNormals();
      RefineEdges(&mesh_, &glow_, 1, [&](std::uint32_t a, std::uint32_t b) {
        return ShouldHalve(a, b);
      });
      // Growth may trickle on for long: houses that stay small get finer every few rounds.
      if (mesh_.triangles.size() > before && round % 4 != 3) continue;
      if (static_cast<int>(mesh_.triangles.size()) >= spec_.min_triangles) {
        if (mesh_.triangles.size() == before) return;
        continue;
      }
      spec_.coarse_edge_m *= kFiner;
      spec_.fine_edge_m *= kFiner;
    }
  }

  bool ShouldHalve(std::uint32_t a, std::uint32_t b) {
    const Vec& p = mesh_.positions[a];
    const Vec& q = mesh_.positions[b];
    const float length = (p - q).norm();
    if (length > spec_.coarse_edge_m) return true;
    if (length < 2.0f * spec_.fine_edge_m) return false;
    const Vec normal = (normals_[a] + normals_[b]).normalized();
    const float at_p = Sketch(p, normal);
    const float at_q = Sketch(q, normal);
    const float between = Sketch(0.5f * (p + q), normal);
    return std::abs(between - 0.5f * (at_p + at_q)) > spec_.change ||
           std::abs(at_p - at_q) > 6.0f * spec_.change;
  }

  void FindNormals() {
    normals_.assign(mesh_.positions.size(), Vec::Zero());
    for (const auto& t : mesh_.triangles) {
      const Vec n = (mesh_.positions[t[1]] - mesh_.positions[t[0]])
                        .cross(mesh_.positions[t[2]] - mesh_.positions[t[0]]);
      for (const std::uint32_t v : t) normals_[v] += n;
    }
    for (Vec& n : normals_) n.normalize();
  }

  /// Display brightness of direct light and nearby occlusion: rough, for deciding where to refine.
  /// The same places are asked for by every edge that ends there, in every round.
  float Sketch(const Vec& p, const Vec& n) {
    PlaceKey key;
    for (int axis = 0; axis < 3; ++axis) {
      key[static_cast<std::size_t>(axis)] = std::bit_cast<std::uint32_t>(p[axis]);
      key[static_cast<std::size_t>(axis) + 3] = std::bit_cast<std::uint32_t>(n[axis]);
    }
    const auto [known, is_new] = sketches_.try_emplace(key, 0.0f);
    if (!is_new) return known->second;
    const Vec point = p + kLift * n;
    const Vec direct = sources_->Irradiance(*coarse_, point, n);
    known->second = Display(direct.mean() + spec_.ambient * Openness(*coarse_, point, n));
    return known->second;
  }

  /// Hits of the directions about n, packet by packet.
  template <class Visit>
  void Gather(const RayTracer& scene, const Vec& point, const Vec& n, int packets,
              const Visit& visit) const {
    for (int p = 0; p < packets; ++p) {
      CastHemisphere(scene, directions_, static_cast<std::size_t>(p), point, n, visit);
    }
  }

  /// How little stands near: 1 in the open, 0 in a crack.
  float Openness(const RayTracer& scene, const Vec& point, const Vec& n) const {
    float open = 0.0f;
    Gather(scene, point, n, 1, [&](const RayHit& hit, const Vec&) {
      open += hit.triangle < 0 ? 1.0f : std::min(1.0f, hit.t / kAmbientReach);
    });
    return open / 16.0f;
  }

  /// Irradiance from windows and lamps, a value a vertex: the mean over its triangles.
  std::vector<Vec> DirectLight() const {
    std::vector<Vec> sum(mesh_.positions.size(), Vec::Zero());
    std::vector<float> count(mesh_.positions.size(), 0.0f);
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t v = mesh_.triangles[t][k];
        if (count[v] >= 2.0f) continue;  // two samples tell enough
        const Place place = PlaceIn(t, k);
        sum[v] += sources_->Irradiance(*coarse_, place.point, place.normal);
        count[v] += 1.0f;
      }
    }
    for (std::size_t v = 0; v < sum.size(); ++v) sum[v] /= std::max(1.0f, count[v]);
    return sum;
  }

  /// Light that comes from other surfaces, and the ambient light that nearby things leave; absent
  /// at vertices that lie inside something.
  std::vector<std::optional<Vec>> GatheredLight(const std::vector<Vec>& direct) const {
    const std::vector<std::array<Vec, 3>> corners = Corners(mesh_);
    const RayTracer scene(corners);
    const std::vector<Vec> albedo = Albedos(mesh_);
    std::vector<std::optional<Vec>> light(mesh_.positions.size());
    std::vector<char> tried(mesh_.positions.size(), 0);
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t v = mesh_.triangles[t][k];
        if (light[v] || tried[v] > 2) continue;
        ++tried[v];
        light[v] = GatherAt(scene, corners, albedo, direct, PlaceIn(t, k));
      }
    }
    return light;
  }

  std::optional<Vec> GatherAt(const RayTracer& scene,
                              const std::vector<std::array<Vec, 3>>& corners,
                              const std::vector<Vec>& albedo, const std::vector<Vec>& direct,
                              const Place& place) const {
    Vec bounced = Vec::Zero();
    float open = 0.0f;
    int inside = 0;
    Gather(scene, place.point, place.normal, kPackets, [&](const RayHit& hit, const Vec& d) {
      if (hit.triangle < 0) {
        open += 1.0f;
        return;
      }
      const auto triangle = static_cast<std::size_t>(hit.triangle);
      if (NormalOf(corners[triangle]).dot(d) > 0.0f && hit.t < kNearBackFace) ++inside;
      open += std::min(1.0f, hit.t / kAmbientReach);
      if (glow_[triangle] != static_cast<int>(Glow::kNone)) return;
      Vec e = Vec::Zero();
      for (const std::uint32_t v : mesh_.triangles[triangle]) e += direct[v] / 3.0f;
      bounced +=
          albedo[mesh_.triangle_materials[triangle]].cwiseProduct(e + Vec::Constant(spec_.ambient));
    });
    constexpr float kCount = 16.0f * kPackets;
    if (inside > 16 * kPackets / 3) return std::nullopt;
    return Vec(kBounce * bounced / kCount + Vec::Constant(spec_.ambient * open / kCount));
  }

  static float Display(float light) {
    const float mapped = 1.0f - Exp(-kExposure * light);
    return kDarkest + (1.0f - kDarkest) * Pow(mapped, 1.0f / 1.9f);
  }

  void WriteColors(const std::vector<Vec>& direct,
                   const std::vector<std::optional<Vec>>& gathered) {
    std::vector<std::optional<Vec>> light(gathered.size());
    for (std::size_t v = 0; v < light.size(); ++v) {
      if (gathered[v]) light[v] = direct[v] + *gathered[v];
    }
    FillFromNeighbours(&light);
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const bool glows = glow_[t] != static_cast<int>(Glow::kNone);
      for (const std::uint32_t v : mesh_.triangles[t]) {
        const Vec e = light[v].value_or(Vec::Constant(spec_.ambient));
        WriteColor(glows ? Vec::Ones() : Vec(e.unaryExpr(&Baker::Display)), v);
      }
    }
  }

  void WriteColor(const Vec& shown, std::uint32_t v) {
    for (int c = 0; c < 3; ++c) {
      mesh_.colors[v][static_cast<std::size_t>(c)] =
          static_cast<std::uint8_t>(std::lround(255.0f * std::min(1.0f, shown[c])));
    }
  }

  /// Vertices inside something take the light of the other corners of their triangles.
  void FillFromNeighbours(std::vector<std::optional<Vec>>* light) const {
    for (int round = 0; round < 3; ++round) FillOnce(light);
  }

  void FillOnce(std::vector<std::optional<Vec>>* light) const {
    std::vector<Vec> sum(light->size(), Vec::Zero());
    std::vector<float> count(light->size(), 0.0f);
    for (const auto& t : mesh_.triangles) {
      for (const std::uint32_t dark : t) {
        if (!(*light)[dark]) AddLit(*light, t, &sum[dark], &count[dark]);
      }
    }
    for (std::size_t v = 0; v < light->size(); ++v) {
      if (count[v] > 0.0f) (*light)[v] = sum[v] / count[v];
    }
  }

  static void AddLit(const std::vector<std::optional<Vec>>& light,
                     const std::array<std::uint32_t, 3>& corners, Vec* sum, float* count) {
    for (const std::uint32_t v : corners) {
      if (!light[v]) continue;
      *sum += *light[v];
      *count += 1.0f;
    }
  }

  SceneMesh& mesh_;
  LightSpec spec_;
  std::vector<int> glow_;
  std::vector<Vec> normals_;
  std::unordered_map<PlaceKey, float, PlaceHash> sketches_;
  const std::array<Vec, kDirections> directions_ = HemisphereDirections<kDirections>();
  std::optional<LightSources> sources_;
  std::optional<RayTracer> coarse_;
};

}  // namespace

void BakeLight(SceneMesh* mesh, std::span<const Glow> glows, const LightSpec& spec) {
  Baker(mesh, glows, spec).Bake();
}

}  // namespace bulletnav::sim
