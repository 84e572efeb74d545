// SPDX-License-Identifier: MIT
#include "benchmark/report/scene_report.h"

#include <algorithm>
#include <vector>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "sim/math/pose.h"

namespace bulletnav::bench {
namespace {

using Vec = Eigen::Vector3f;

constexpr std::size_t kMaxProbes = 400;
constexpr int kSweeps = 4;

/// Corners of the largest island's polygons, thinned out evenly.
std::vector<Vec> ProbePoints(const sim::Navmesh& navmesh) {
  std::vector<Vec> corners;
  for (std::size_t t = 0; t < navmesh.triangle_islands().size(); ++t) {
    if (navmesh.triangle_islands()[t] != 0) continue;
    for (std::size_t k = 0; k < 3; ++k) corners.push_back(navmesh.triangle_corners()[3 * t + k]);
  }
  std::vector<Vec> probes;
  const std::size_t step = corners.size() / kMaxProbes + 1;
  for (std::size_t i = 0; i < corners.size(); i += step) probes.push_back(corners[i]);
  return probes;
}

double LongestGeodesic(const sim::Navmesh& navmesh) {
  const std::vector<Vec> probes = ProbePoints(navmesh);
  if (probes.empty()) return 0.0;
  const sim::NavmeshQuery query(navmesh);
  Vec from = probes.front();
  double longest = 0.0;
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    double farthest = 0.0;
    Vec end = from;
    for (const Vec& to : probes) {
      const auto path = query.FindPath(from, to);
      if (!path || path->length <= farthest) continue;
      farthest = path->length;
      end = to;
    }
    from = end;
    if (farthest <= longest) break;
    longest = farthest;
  }
  return longest;
}

nlohmann::ordered_json DoorsJson(const std::vector<sim::DoorLeaf>& doors) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const sim::DoorLeaf& door : doors) {
    list.push_back({{"object", door.object},
                    {"hinge", {door.hinge.x(), door.hinge.y(), door.hinge.z()}},
                    {"axis", {door.axis.x(), door.axis.y(), door.axis.z()}},
                    {"width_m", door.width},
                    {"angle_deg", sim::RadToDeg(double{door.angle})},
                    {"open", door.is_open()},
                    {"leads_outside", door.leads_outside}});
  }
  return list;
}

}  // namespace

SceneReport InspectScene(const sim::ImportReport& import, const sim::Navmesh& navmesh) {
  SceneReport report;
  report.import = import;
  report.islands = static_cast<int>(navmesh.islands().size());
  report.walkable_m2 = navmesh.area();
  report.is_open = navmesh.is_open();
  report.longest_geodesic_m = LongestGeodesic(navmesh);
  return report;
}

std::string ToJson(const SceneReport& report) {
  const sim::ImportReport& import = report.import;
  nlohmann::ordered_json json = {
      {"triangles", import.triangles},
      {"materials", import.materials},
      {"textures_found", import.textures_found},
      {"textures_missing", import.textures_missing.size()},
      {"extent_m", {import.extent_m.x(), import.extent_m.y(), import.extent_m.z()}},
      {"up_axis", import.up_axis == sim::UpAxis::kY ? "y" : "z"},
      {"islands", report.islands},
      {"walkable_m2", report.walkable_m2},
      {"is_open", report.is_open},
      {"longest_geodesic_m", report.longest_geodesic_m},
      {"skipped", import.skipped},
      {"missing_textures", import.textures_missing},
  };
  if (!report.doors.empty()) json["doors"] = DoorsJson(report.doors);
  return json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::string ToText(const SceneReport& report) {
  const sim::ImportReport& import = report.import;
  std::string text = fmt::format(
      "triangles         {}\n"
      "materials         {}\n"
      "textures          {} found, {} missing\n"
      "extent            {:.2f} x {:.2f} x {:.2f} m (x, y up, z)\n"
      "up axis as read   {}\n"
      "walkable          {:.1f} m2 in {} island{}{}\n"
      "longest geodesic  {:.1f} m\n",
      import.triangles, import.materials, import.textures_found, import.textures_missing.size(),
      import.extent_m.x(), import.extent_m.y(), import.extent_m.z(),
      import.up_axis == sim::UpAxis::kY ? "y" : "z", report.walkable_m2, report.islands,
      report.islands == 1 ? "" : "s",
      report.is_open ? "; nothing is indoors, so that all that is level counts, roofs too" : "",
      report.longest_geodesic_m);
  if (!report.doors.empty()) {
    const auto open =
        std::count_if(report.doors.begin(), report.doors.end(), [](const sim::DoorLeaf& door) {
          return door.is_open();
        });
    text += fmt::format("doors             {}, {} open\n", report.doors.size(), open);
  }
  for (const std::string& line : import.skipped) text += "skipped           " + line + "\n";
  for (const std::string& line : import.textures_missing)
    text += "missing texture   " + line + "\n";
  return text;
}

}  // namespace bulletnav::bench
