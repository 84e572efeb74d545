// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "sim/config/yaml_reader.h"
#include "sim/math/rng.h"
#include "sim/scene/mesh.h"

namespace bulletnav::sim {

/// Recast's settings, and what counts as floor. Defaults: habitat-sim's, for the standard body.
struct NavmeshSpec {
  float cell_size = 0.05f;
  float cell_height = 0.2f;
  float agent_height = 1.5f;
  float agent_radius = 0.1f;
  float max_climb = 0.2f;
  float max_slope_deg = 45.0f;
  float region_min_size = 20.0f;  // cells, squared for the area
  float region_merge_size = 20.0f;
  float edge_max_length = 12.0f;
  float edge_max_error = 1.3f;
  int verts_per_poly = 6;
  float detail_sample_distance = 6.0f;
  float detail_sample_max_error = 1.0f;
  /// Leaves out what is no floor of a building: the outdoors, roofs, tops of furniture (see
  /// Navmesh). False: all that Recast finds, as Habitat has it; for scenes cut open. Not in records
  /// unless it is given.
  std::optional<bool> indoor_only = {};

  bool is_indoor() const { return indoor_only.value_or(true); }

  template <class V>
  void Visit(V& v) {
    v("cell_size", cell_size);
    v("cell_height", cell_height);
    v("agent_height", agent_height);
    v("agent_radius", agent_radius);
    v("max_climb", max_climb);
    v("max_slope_deg", max_slope_deg);
    v("region_min_size", region_min_size);
    v("region_merge_size", region_merge_size);
    v("edge_max_length", edge_max_length);
    v("edge_max_error", edge_max_error);
    v("verts_per_poly", verts_per_poly);
    v("detail_sample_distance", detail_sample_distance);
    v("detail_sample_max_error", detail_sample_max_error);
    v("indoor_only", indoor_only);
  }
  void Validate() const;
};

/// A connected part of the walkable floor.
struct Island {
  float area = 0.0f;    // m2
  float radius = 0.0f;  // of its corners around their mean, as Habitat's island radius
};

/// A walk along the floor.
struct Path {
  double length = 0.0;
  std::vector<Eigen::Vector3f> points;  // start, corners, end
};

/// Where the body can stand and how far it is from there to there: ground truth for episodes and
/// metrics, never for agents or for motion. Immutable; threads share it and each make a query.
/// Heights are those of Recast's cells (cell_height) and may lie 0.2 to 0.4 m beside the mesh; the
/// body finds the floor itself (CapsuleBody::Reset). Triangles count as floor by the side that
/// their corners wind counter-clockwise on. Source: Recast/Detour. Floor is what a body can stand
/// on indoors: under something or, where there is no ceiling, with walls around; on every storey.
/// No roofs (uncovered, floor below, no way up), no tops of furniture, no outdoors; but all of it
/// in open scenes, of which next to nothing is indoors. NavmeshSpec::indoor_only turns this off.
class Navmesh {
 public:
  /// Throws Error, with the remedy, if the mesh is too large for Recast; it names the scene `name`.
  Navmesh(const SceneMesh& mesh, const NavmeshSpec& spec, const std::string& name = {});
  ~Navmesh();
  Navmesh(const Navmesh&) = delete;
  Navmesh& operator=(const Navmesh&) = delete;
  Navmesh(Navmesh&&) = delete;
  Navmesh& operator=(Navmesh&&) = delete;

  /// Largest first; empty if there is no floor to walk on.
  const std::vector<Island>& islands() const;
  /// Next to nothing is indoors, so that all that is level counts as floor, roofs too.
  bool is_open() const;
  /// Walkable m2 of all islands.
  float area() const;
  /// Triangles of the walkable surface, corner after corner, and each triangle's island; for
  /// drawing.
  const std::vector<Eigen::Vector3f>& triangle_corners() const;
  const std::vector<int>& triangle_islands() const;

 private:
  friend class NavmeshQuery;
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// One thread's access to a navmesh, which must outlive it.
class NavmeshQuery {
 public:
  explicit NavmeshQuery(const Navmesh& navmesh);
  ~NavmeshQuery();
  NavmeshQuery(const NavmeshQuery&) = delete;
  NavmeshQuery& operator=(const NavmeshQuery&) = delete;
  NavmeshQuery(NavmeshQuery&&) noexcept;
  NavmeshQuery& operator=(NavmeshQuery&&) = delete;

  /// Nearest point of the walkable floor, within 2 m sideways and 4 m up or down like Habitat's
  /// snap.
  std::optional<Eigen::Vector3f> Snap(const Eigen::Vector3f& point) const;
  /// Island of the floor that Snap finds; absent if it finds none.
  std::optional<int> IslandOf(const Eigen::Vector3f& point) const;
  /// Shortest path between the points that Snap finds, also where these are farther off, behind a
  /// wall say; absent between islands. It is Detour's: shortest within a corridor of polygons that
  /// is chosen by the middles of their edges, so rarely a longer way than the shortest (in
  /// generated houses 7% at most of those tried, on a mesh with many levels up to 48%). Cost:
  /// 20-120 us.
  std::optional<Path> FindPath(const Eigen::Vector3f& from, const Eigen::Vector3f& to) const;
  /// Its length; infinite where there is none.
  double GeodesicDistance(const Eigen::Vector3f& from, const Eigen::Vector3f& to) const;
  /// A point drawn evenly from the area of one island, or of all of them, if `island` is -1.
  /// Expects: some walkable floor, -1 <= island < islands (checked).
  Eigen::Vector3f RandomPoint(Rng* rng, int island = -1) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace bulletnav::sim
