// SPDX-License-Identifier: MIT
#include "sim/navmesh/navmesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>

#include <fmt/core.h>
#include <recastnavigation/DetourNavMesh.h>
#include <recastnavigation/DetourNavMeshQuery.h>

#include "sim/base/check.h"
#include "sim/base/error.h"
#include "sim/navmesh/recast_build.h"

namespace bulletnav::sim {
namespace {

constexpr int kMaxSearchNodes = 65535;  // as many as a tile has polygons
constexpr std::array<float, 3> kSnapReach = {2.0f, 4.0f, 2.0f};

using Vec = Eigen::Vector3f;

struct FreeDetour {
  void operator()(dtNavMesh* p) const { dtFreeNavMesh(p); }
  void operator()(dtNavMeshQuery* p) const { dtFreeNavMeshQuery(p); }
};

/// Root of i in a forest of parents, shortening the way.
int Root(std::vector<int>* parent, int i) {
  while ((*parent)[static_cast<std::size_t>(i)] != i) {
    int& up = (*parent)[static_cast<std::size_t>(i)];
    up = (*parent)[static_cast<std::size_t>(up)];
    i = up;
  }
  return i;
}

}  // namespace

void NavmeshSpec::Validate() const {
  constexpr float kMostCells = 120.0f;  // in the body's radius: Recast counts twice that in a byte
  const auto require = [](const char* name, float value, float least, float most) {
    if (value >= least && value <= most) return;
    throw Error(fmt::format("{} is {}; it must be in {}..{}", name, value, least, most));
  };
  require("cell_size", cell_size, 0.005f, 1.0f);
  require("cell_height", cell_height, 0.005f, 1.0f);
  require("agent_height", agent_height, 0.05f, 10.0f);
  require("agent_radius", agent_radius, 0.0f, kMostCells * cell_size);
  require("max_climb", max_climb, 0.0f, 10.0f);
  require("max_slope_deg", max_slope_deg, 0.0f, 90.0f);
  require("region_min_size", region_min_size, 0.0f, 1000.0f);
  require("region_merge_size", region_merge_size, 0.0f, 1000.0f);
  require("edge_max_length", edge_max_length, 0.0f, 1000.0f);
  require("edge_max_error", edge_max_error, 0.1f, 100.0f);
  require("detail_sample_distance", detail_sample_distance, 0.0f, 100.0f);
  require("detail_sample_max_error", detail_sample_max_error, 0.0f, 100.0f);
  if (verts_per_poly < 3 || verts_per_poly > DT_VERTS_PER_POLYGON) {
    throw Error("verts_per_poly must lie between 3 and 6");
  }
}

struct Navmesh::Impl {
  explicit Impl(DetourTile tile) : data(std::move(tile.bytes)), is_open(tile.is_open) {
    if (data.empty()) return;
    // Detour takes over, changes and frees the memory it is given.
    auto* copy = static_cast<unsigned char*>(dtAlloc(data.size(), DT_ALLOC_PERM));
    BULLETNAV_CHECK(copy != nullptr);
    std::memcpy(copy, data.data(), data.size());
    detour.reset(dtAllocNavMesh());
    if (dtStatusFailed(detour->init(copy, static_cast<int>(data.size()), DT_TILE_FREE_DATA))) {
      dtFree(copy);
      throw Error("the navmesh data is damaged");
    }
    FindIslands();
    CollectTriangles();
  }

  const dtMeshTile& tile() const { return *static_cast<const dtNavMesh&>(*detour).getTile(0); }
  int polygon_count() const { return tile().header->polyCount; }

  /// As the filters of queries see it.
  bool IsFloor(int i) const { return tile().polys[i].flags != 0; }

  /// Polygons joined through their links, numbered by falling area.
  void FindIslands() {
    std::vector<int> parent(static_cast<std::size_t>(polygon_count()));
    std::iota(parent.begin(), parent.end(), 0);
    for (int i = 0; i < polygon_count(); ++i) {
      if (!IsFloor(i)) continue;
      for (unsigned k = tile().polys[i].firstLink; k != DT_NULL_LINK; k = tile().links[k].next) {
        const auto other = static_cast<int>(detour->decodePolyIdPoly(tile().links[k].ref));
        if (!IsFloor(other)) continue;
        parent[static_cast<std::size_t>(Root(&parent, i))] = Root(&parent, other);
      }
    }
    for (int i = 0; i < polygon_count(); ++i) {
      island_of_polygon.push_back(IsFloor(i) ? Root(&parent, i) : -1);
    }
  }

  Vec DetailCorner(const dtPoly& polygon, const dtPolyDetail& detail, unsigned char k) const {
    const float* v =
        k < polygon.vertCount
            ? &tile().verts[std::size_t{3} * polygon.verts[k]]
            : &tile().detailVerts[std::size_t{3} * (detail.vertBase + k - polygon.vertCount)];
    return {v[0], v[1], v[2]};
  }

  void CollectTriangles() {
    for (int i = 0; i < polygon_count(); ++i) {
      if (IsFloor(i)) CollectTrianglesOf(i);
    }
    RenumberIslands();
    MeasureIslands();
  }

  void CollectTrianglesOf(int i) {
    const dtPoly& polygon = tile().polys[i];
    const dtPolyDetail& detail = tile().detailMeshes[i];
    for (unsigned t = detail.triBase; t < detail.triBase + detail.triCount; ++t) {
      const unsigned char* triangle = &tile().detailTris[std::size_t{4} * t];
      for (const unsigned char k : {triangle[0], triangle[1], triangle[2]}) {
        corners.push_back(DetailCorner(polygon, detail, k));
      }
      islands_of_triangles.push_back(island_of_polygon[static_cast<std::size_t>(i)]);
    }
  }

  static float Area(const Vec* corner) {
    return 0.5f * (corner[1] - corner[0]).cross(corner[2] - corner[0]).norm();
  }

  void RenumberIslands() {
    std::vector<float> area(static_cast<std::size_t>(polygon_count()), 0.0f);
    for (std::size_t t = 0; t < islands_of_triangles.size(); ++t) {
      area[static_cast<std::size_t>(islands_of_triangles[t])] += Area(&corners[3 * t]);
    }
    std::vector<int> roots;
    for (int i = 0; i < polygon_count(); ++i) {
      if (island_of_polygon[static_cast<std::size_t>(i)] == i) roots.push_back(i);
    }
    std::stable_sort(roots.begin(), roots.end(), [&](int a, int b) {
      return area[static_cast<std::size_t>(a)] > area[static_cast<std::size_t>(b)];
    });
    std::vector<int> number(static_cast<std::size_t>(polygon_count()), -1);
    for (std::size_t n = 0; n < roots.size(); ++n) {
      number[static_cast<std::size_t>(roots[n])] = static_cast<int>(n);
    }
    for (int& island : island_of_polygon) {
      if (island >= 0) island = number[static_cast<std::size_t>(island)];
    }
    for (int& island : islands_of_triangles) island = number[static_cast<std::size_t>(island)];
    islands.resize(roots.size());
  }

  void MeasureIslands() {
    std::vector<Vec> mean(islands.size(), Vec::Zero());
    std::vector<float> count(islands.size(), 0.0f);
    triangles_of_island.resize(islands.size());
    area_up_to.resize(islands.size());
    for (std::size_t t = 0; t < islands_of_triangles.size(); ++t) {
      const auto n = static_cast<std::size_t>(islands_of_triangles[t]);
      islands[n].area += Area(&corners[3 * t]);
      triangles_of_island[n].push_back(t);
      area_up_to[n].push_back(islands[n].area);
      for (std::size_t k = 0; k < 3; ++k) mean[n] += corners[3 * t + k];
      count[n] += 3.0f;
    }
    for (std::size_t t = 0; t < islands_of_triangles.size(); ++t) {
      const auto n = static_cast<std::size_t>(islands_of_triangles[t]);
      for (std::size_t k = 0; k < 3; ++k) {
        const float distance = (corners[3 * t + k] - mean[n] / count[n]).norm();
        islands[n].radius = std::max(islands[n].radius, distance);
      }
    }
  }

  std::vector<std::uint8_t> data;
  bool is_open = false;
  std::unique_ptr<dtNavMesh, FreeDetour> detour;
  std::vector<int> island_of_polygon;
  std::vector<Island> islands;
  std::vector<Vec> corners;
  std::vector<int> islands_of_triangles;
  std::vector<std::vector<std::size_t>> triangles_of_island;
  std::vector<std::vector<float>> area_up_to;  // running sums over triangles_of_island
};

Navmesh::Navmesh(const SceneMesh& mesh, const NavmeshSpec& spec, const std::string& name) {
  try {
    impl_ = std::make_unique<Impl>(BuildDetourTile(mesh, spec));
  } catch (const Error& error) {
    if (name.empty()) throw;
    throw Error(name + ": " + error.what());
  }
}

Navmesh::~Navmesh() = default;

bool Navmesh::is_open() const {
  return impl_->is_open;
}

const std::vector<Island>& Navmesh::islands() const {
  return impl_->islands;
}
const std::vector<Vec>& Navmesh::triangle_corners() const {
  return impl_->corners;
}
const std::vector<int>& Navmesh::triangle_islands() const {
  return impl_->islands_of_triangles;
}

float Navmesh::area() const {
  float sum = 0.0f;
  for (const Island& island : impl_->islands) sum += island.area;
  return sum;
}

struct NavmeshQuery::Impl {
  explicit Impl(const Navmesh::Impl& navmesh) : mesh(navmesh) {
    if (!mesh.detour) return;
    detour.reset(dtAllocNavMeshQuery());
    BULLETNAV_CHECK(dtStatusSucceed(detour->init(mesh.detour.get(), kMaxSearchNodes)));
    polygons.resize(static_cast<std::size_t>(mesh.polygon_count()) + 2);
    points.resize(3 * polygons.size());
  }

  struct Place {
    dtPolyRef polygon = 0;
    Vec point = Vec::Zero();
  };

  std::optional<Place> Find(const Vec& p) const {
    if (!detour || !p.allFinite()) return std::nullopt;
    Place place;
    const dtStatus status = detour->findNearestPoly(p.data(), kSnapReach.data(), &filter,
                                                    &place.polygon, place.point.data());
    if (dtStatusFailed(status) || place.polygon == 0) return std::nullopt;
    return place;
  }

  /// A corridor of polygons from one place to another of the same island, and the path pulled tight
  /// inside it.
  Path Pull(const Place& start, const Place& end) const {
    const auto capacity = static_cast<int>(polygons.size());
    int count = 0;
    const dtStatus status =
        detour->findPath(start.polygon, end.polygon, start.point.data(), end.point.data(), &filter,
                         polygons.data(), &count, capacity);
    BULLETNAV_CHECK(dtStatusSucceed(status) && !dtStatusDetail(status, DT_PARTIAL_RESULT));
    int corners = 0;
    BULLETNAV_CHECK(dtStatusSucceed(
        detour->findStraightPath(start.point.data(), end.point.data(), polygons.data(), count,
                                 points.data(), nullptr, nullptr, &corners, capacity)));
    Path path;
    for (int i = 0; i < corners; ++i) {
      const float* p = &points[3 * static_cast<std::size_t>(i)];
      path.points.emplace_back(p[0], p[1], p[2]);
      if (i > 0) path.length += (path.points[path.points.size() - 2] - path.points.back()).norm();
    }
    return path;
  }

  int Island(const Place& place) const {
    return mesh.island_of_polygon[mesh.detour->decodePolyIdPoly(place.polygon)];
  }

  const Navmesh::Impl& mesh;
  std::unique_ptr<dtNavMeshQuery, FreeDetour> detour;
  dtQueryFilter filter;
  mutable std::vector<dtPolyRef> polygons;
  mutable std::vector<float> points;
};

NavmeshQuery::NavmeshQuery(const Navmesh& navmesh)
    : impl_(std::make_unique<Impl>(*navmesh.impl_)) {}
NavmeshQuery::~NavmeshQuery() = default;
NavmeshQuery::NavmeshQuery(NavmeshQuery&&) noexcept = default;

std::optional<Vec> NavmeshQuery::Snap(const Vec& point) const {
  const auto place = impl_->Find(point);
  return place ? std::optional(place->point) : std::nullopt;
}

std::optional<int> NavmeshQuery::IslandOf(const Vec& point) const {
  const auto place = impl_->Find(point);
  return place ? std::optional(impl_->Island(*place)) : std::nullopt;
}

std::optional<Path> NavmeshQuery::FindPath(const Vec& from, const Vec& to) const {
  const auto start = impl_->Find(from);
  const auto end = impl_->Find(to);
  if (!start || !end || impl_->Island(*start) != impl_->Island(*end)) return std::nullopt;
  // Detour's A* measures along the middles of polygon edges, so its corridor is not always the
  // shortest, nor the same both ways; the better of the two ways is nearer the truth and symmetric.
  Path there = impl_->Pull(*start, *end);
  Path back = impl_->Pull(*end, *start);
  if (there.length <= back.length) return there;
  std::reverse(back.points.begin(), back.points.end());
  return back;
}

double NavmeshQuery::GeodesicDistance(const Vec& from, const Vec& to) const {
  const auto path = FindPath(from, to);
  return path ? path->length : std::numeric_limits<double>::infinity();
}

Vec NavmeshQuery::RandomPoint(Rng* rng, int island) const {
  const auto& islands = impl_->mesh.islands;
  if (islands.empty()) throw Error("the scene has no floor to draw a point from");
  const auto count = static_cast<int>(islands.size());
  if (island < -1 || island >= count) {
    throw Error(fmt::format("there is no island {} to draw a point from, of {}", island, count));
  }
  if (island == -1) {
    std::vector<double> areas;
    areas.reserve(islands.size());
    for (const auto& i : islands) areas.push_back(i.area);
    island = static_cast<int>(rng->Weighted(areas));
  }
  const auto n = static_cast<std::size_t>(island);
  const auto& sums = impl_->mesh.area_up_to[n];
  const auto target = static_cast<float>(rng->Uniform() * sums.back());
  const auto found = std::upper_bound(sums.begin(), sums.end(), target);
  const auto index =
      std::min<std::size_t>(static_cast<std::size_t>(found - sums.begin()), sums.size() - 1);
  const Vec* corner = &impl_->mesh.corners[3 * impl_->mesh.triangles_of_island[n][index]];
  // The square root spreads points evenly over the triangle.
  const auto s = static_cast<float>(std::sqrt(rng->Uniform()));
  const auto t = static_cast<float>(rng->Uniform());
  return (1 - s) * corner[0] + s * (1 - t) * corner[1] + s * t * corner[2];
}

}  // namespace bulletnav::sim
