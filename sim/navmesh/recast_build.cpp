// SPDX-License-Identifier: MIT
#include "sim/navmesh/recast_build.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include <fmt/core.h>
#include <recastnavigation/DetourNavMeshBuilder.h>
#include <recastnavigation/Recast.h>

#include "sim/base/elementary.h"
#include "sim/base/error.h"
#include "sim/navmesh/indoors.h"
#include "sim/navmesh/tops.h"

namespace bulletnav::sim {
namespace {

constexpr std::int64_t kMaxCells = 64'000'000;
constexpr int kMaxSpans = 1 << 24;  // what rcCompactCell can count
constexpr float kLayer = 0.1f;
constexpr std::uint16_t kWalkableFlag = 1;

struct Free {
  void operator()(rcHeightfield* p) const { rcFreeHeightField(p); }
  void operator()(rcCompactHeightfield* p) const { rcFreeCompactHeightfield(p); }
  void operator()(rcContourSet* p) const { rcFreeContourSet(p); }
  void operator()(rcPolyMesh* p) const { rcFreePolyMesh(p); }
  void operator()(rcPolyMeshDetail* p) const { rcFreePolyMeshDetail(p); }
  void operator()(unsigned char* p) const { dtFree(p); }
};
template <class T>
using Owned = std::unique_ptr<T, Free>;

void Require(bool done, const char* what) {
  if (!done) throw Error(std::string("the navmesh cannot be built: Recast failed to ") + what);
}

/// Scans and CAD exports often have floors that face down. Then every triangle counts as two-sided;
/// otherwise windings are believed, as the far side of a ceiling is no place to walk.
bool FloorFacesDown(const SceneMesh& mesh) {
  struct Areas {
    double up = 0.0;
    double down = 0.0;
  };
  std::map<int, Areas> layers;
  double largest = 0.0;
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3f& a = mesh.positions[t[0]];
    const Eigen::Vector3f n = (mesh.positions[t[1]] - a).cross(mesh.positions[t[2]] - a);
    if (std::abs(n.y()) < 0.95f * n.norm()) continue;
    Areas& layer = layers[static_cast<int>(std::floor(a.y() / kLayer))];
    (n.y() > 0.0f ? layer.up : layer.down) += std::abs(n.y());
    largest = std::max(largest, layer.up + layer.down);
  }
  for (const auto& [height, layer] : layers) {
    if (layer.up + layer.down >= 0.25 * largest) return layer.down > layer.up;
  }
  return false;
}

/// The pipeline's stages in their order; each keeps what the next one needs.
class RecastBuilder {
 public:
  RecastBuilder(const SceneMesh& mesh, const NavmeshSpec& spec) : mesh_(mesh), spec_(spec) {
    Configure();
  }

  DetourTile Build() {
    Voxelise();
    Partition();
    Trace();
    DetourTile tile;
    if (polygons_->npolys > 0) tile.bytes = Pack();
    tile.is_open = is_open_;
    return tile;
  }

 private:
  void Configure() {
    const float cs = spec_.cell_size;
    const float ch = spec_.cell_height;
    config_.cs = cs;
    config_.ch = ch;
    config_.walkableSlopeAngle = spec_.max_slope_deg;
    config_.walkableHeight = static_cast<int>(std::ceil(spec_.agent_height / ch));
    config_.walkableClimb = static_cast<int>(std::floor(spec_.max_climb / ch + 1e-4f));
    config_.walkableRadius = static_cast<int>(std::ceil(spec_.agent_radius / cs - 1e-4f));
    config_.maxEdgeLen = static_cast<int>(spec_.edge_max_length / cs);
    config_.maxSimplificationError = spec_.edge_max_error;
    config_.minRegionArea = static_cast<int>(rcSqr(spec_.region_min_size));
    config_.mergeRegionArea = static_cast<int>(rcSqr(spec_.region_merge_size));
    config_.maxVertsPerPoly = spec_.verts_per_poly;
    config_.detailSampleDist =
        spec_.detail_sample_distance < 0.9f ? 0.0f : cs * spec_.detail_sample_distance;
    config_.detailSampleMaxError = ch * spec_.detail_sample_max_error;
    const Eigen::AlignedBox3f box = mesh_.Bounds();
    for (int i = 0; i < 3; ++i) {
      config_.bmin[i] = box.min()[i];
      config_.bmax[i] = box.max()[i];
    }
    config_.bmax[1] += spec_.agent_height;  // head room over a roofless floor
    rcCalcGridSize(config_.bmin, config_.bmax, cs, &config_.width, &config_.height);
    config_.width = std::max(1, config_.width);
    config_.height = std::max(1, config_.height);
    if (std::int64_t{config_.width} * config_.height > kMaxCells) {
      throw Error(fmt::format(
          "the scene is {:.0f} x {:.0f} m, too large for a navmesh of {} m cells; "
          "cut it up, or give --scale (in a config: import.scale) if it is not in metres",
          box.sizes().x(), box.sizes().z(), cs));
    }
  }

  void Voxelise() {
    heights_.reset(rcAllocHeightfield());
    Require(rcCreateHeightfield(&context_, *heights_, config_.width, config_.height, config_.bmin,
                                config_.bmax, config_.cs, config_.ch),
            "make its grid");
    const bool two_sided = FloorFacesDown(mesh_);
    const float least_up = Cos(config_.walkableSlopeAngle / 180.0f * RC_PI);
    for (const auto& t : mesh_.triangles) {
      const Eigen::Vector3f& a = mesh_.positions[t[0]];
      const Eigen::Vector3f& b = mesh_.positions[t[1]];
      const Eigen::Vector3f& c = mesh_.positions[t[2]];
      const Eigen::Vector3f n = (b - a).cross(c - a).normalized();
      const float up = two_sided ? std::abs(n.y()) : n.y();
      const unsigned char area = up > least_up ? RC_WALKABLE_AREA : RC_NULL_AREA;
      Require(rcRasterizeTriangle(&context_, a.data(), b.data(), c.data(), area, *heights_,
                                  config_.walkableClimb),
              "voxelise");
    }
    rcFilterLowHangingWalkableObstacles(&context_, config_.walkableClimb, *heights_);
    rcFilterLedgeSpans(&context_, config_.walkableHeight, config_.walkableClimb, *heights_);
    rcFilterWalkableLowHeightSpans(&context_, config_.walkableHeight, *heights_);
  }

  void Partition() {
    compact_.reset(rcAllocCompactHeightfield());
    Require(rcBuildCompactHeightfield(&context_, config_.walkableHeight, config_.walkableClimb,
                                      *heights_, *compact_),
            "compact its grid");
    if (compact_->spanCount >= kMaxSpans) {
      throw Error(fmt::format(
          "the scene has more floor than one navmesh of {} m cells holds ({}); "
          "cut it up, or give --scale (in a config: import.scale) if it is not in metres",
          config_.cs, kMaxSpans));
    }
    std::vector<Surroundings> surroundings;
    if (spec_.is_indoor()) {
      surroundings = LookAround(*heights_, *compact_);
      is_open_ = !KeepIndoors(surroundings, compact_.get());
    }
    Require(rcErodeWalkableArea(&context_, config_.walkableRadius, *compact_), "erode");
    Require(rcBuildDistanceField(&context_, *compact_), "measure distances");
    Require(rcBuildRegions(&context_, *compact_, 0, config_.minRegionArea, config_.mergeRegionArea),
            "find regions");
    if (spec_.is_indoor()) {
      is_off_floor_ = RegionsOffTheFloor(*heights_, *compact_, surroundings);
    }
    heights_.reset();
  }

  void Trace() {
    const Owned<rcContourSet> contours(rcAllocContourSet());
    Require(rcBuildContours(&context_, *compact_, config_.maxSimplificationError,
                            config_.maxEdgeLen, *contours),
            "trace contours");
    polygons_.reset(rcAllocPolyMesh());
    Require(rcBuildPolyMesh(&context_, *contours, config_.maxVertsPerPoly, *polygons_),
            "make polygons");
    detail_.reset(rcAllocPolyMeshDetail());
    Require(rcBuildPolyMeshDetail(&context_, *polygons_, *compact_, config_.detailSampleDist,
                                  config_.detailSampleMaxError, *detail_),
            "add detail");
    for (int i = 0; i < polygons_->npolys; ++i) {
      const bool is_floor = is_off_floor_.empty() || !is_off_floor_[polygons_->regs[i]];
      polygons_->flags[i] = polygons_->areas[i] == RC_WALKABLE_AREA && is_floor ? kWalkableFlag : 0;
    }
  }

  std::vector<std::uint8_t> Pack() const {
    dtNavMeshCreateParams params{};
    params.verts = polygons_->verts;
    params.vertCount = polygons_->nverts;
    params.polys = polygons_->polys;
    params.polyAreas = polygons_->areas;
    params.polyFlags = polygons_->flags;
    params.polyCount = polygons_->npolys;
    params.nvp = polygons_->nvp;
    params.detailMeshes = detail_->meshes;
    params.detailVerts = detail_->verts;
    params.detailVertsCount = detail_->nverts;
    params.detailTris = detail_->tris;
    params.detailTriCount = detail_->ntris;
    params.walkableHeight = spec_.agent_height;
    params.walkableRadius = spec_.agent_radius;
    params.walkableClimb = spec_.max_climb;
    rcVcopy(params.bmin, polygons_->bmin);
    rcVcopy(params.bmax, polygons_->bmax);
    params.cs = config_.cs;
    params.ch = config_.ch;
    params.buildBvTree = true;
    unsigned char* data = nullptr;
    int size = 0;
    if (!dtCreateNavMeshData(&params, &data, &size)) {
      throw Error("the scene has more floor than one navmesh holds (65,535 corners); cut it up");
    }
    const Owned<unsigned char> owned(data);
    return {data, data + size};
  }

  const SceneMesh& mesh_;
  const NavmeshSpec& spec_;
  rcContext context_{false};
  rcConfig config_{};
  Owned<rcHeightfield> heights_;
  bool is_open_ = false;
  std::vector<bool> is_off_floor_;  // by region; empty if all are floor
  Owned<rcCompactHeightfield> compact_;
  Owned<rcPolyMesh> polygons_;
  Owned<rcPolyMeshDetail> detail_;
};

}  // namespace

DetourTile BuildDetourTile(const SceneMesh& mesh, const NavmeshSpec& spec) {
  spec.Validate();
  return RecastBuilder(mesh, spec).Build();
}

}  // namespace bulletnav::sim
