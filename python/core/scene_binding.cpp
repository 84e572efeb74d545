// SPDX-License-Identifier: MIT
#include "python/core/arguments.h"
#include "python/core/array.h"
#include "python/core/bindings.h"
#include "python/core/scene.h"

#include <array>
#include <cmath>

#include <pybind11/stl.h>

#include "sim/base/error.h"

namespace bulletnav::python {
namespace {

namespace py = pybind11;
using Point = std::array<float, 3>;
using Pose = std::array<double, 4>;

Eigen::Vector3f Read(const Point& point) {
  for (const float value : point) {
    if (!std::isfinite(value)) throw sim::Error("bulletnav scene: a point must be finite numbers");
  }
  return {point[0], point[1], point[2]};
}

Point Told(const Eigen::Vector3f& point) {
  return {point.x(), point.y(), point.z()};
}

std::vector<Point> Told(const std::vector<Eigen::Vector3f>& points) {
  std::vector<Point> told;
  told.reserve(points.size());
  for (const Eigen::Vector3f& point : points) told.push_back(Told(point));
  return told;
}

std::optional<Point> Snap(const Scene& scene, const Point& point) {
  const auto found = scene.Query().Snap(Read(point));
  return found ? std::optional(Told(*found)) : std::nullopt;
}

std::optional<std::pair<double, std::vector<Point>>> FindPath(const Scene& scene, const Point& from,
                                                              const Point& to) {
  const auto path = scene.Query().FindPath(Read(from), Read(to));
  if (!path) return std::nullopt;
  return std::pair(path->length, Told(path->points));
}

sim::CameraSpec CameraOf(const std::string& type, const std::string& settings) {
  if (type == "panorama") return ReadArguments<sim::PanoramaSpec>(settings);
  if (type == "pinhole") return ReadArguments<sim::PinholeSpec>(settings);
  throw sim::Error("bulletnav scene: a camera's type is panorama or pinhole, not '" + type + "'");
}

/// Colour [n, rows, cols, 3] and depth [n, rows, cols].
std::pair<Array, Array> Render(Scene& scene, const std::vector<Pose>& poses,
                               const std::string& type, const std::string& settings) {
  const sim::CameraSpec camera = CameraOf(type, settings);
  const sim::PictureSize size = sim::SizeOf(camera);
  const auto n = static_cast<int>(poses.size());
  std::vector<sim::CameraPose> cameras;
  cameras.reserve(poses.size());
  for (const Pose& pose : poses) {
    const Eigen::Vector3d eye(pose[0], pose[1], pose[2]);
    cameras.push_back({eye.cast<float>(), static_cast<float>(pose[3])});
  }
  Array color = MakeArray({"color", {n, size.rows, size.cols, 3}, sim::Element::kUint8, ""});
  Array depth = MakeArray({"depth", {n, size.rows, size.cols}, sim::Element::kFloat32, "m"});
  const std::size_t pixels = poses.size() * size.pixels();
  if (n > 0) {
    const py::gil_scoped_release unlocked;
    scene.Render(camera, cameras, {reinterpret_cast<std::uint8_t*>(color.data), 3 * pixels},
                 {reinterpret_cast<float*>(depth.data), pixels});
  }
  return {std::move(color), std::move(depth)};
}

py::list Islands(const Scene& scene) {
  py::list islands;
  for (const sim::Island& island : scene.world().navmesh().islands()) {
    py::dict facts;
    facts["area"] = island.area;
    facts["radius"] = island.radius;
    islands.append(facts);
  }
  return islands;
}

py::dict Report(const Scene& scene) {
  const sim::ImportReport& report = scene.world().report();
  py::dict facts;
  facts["triangles"] = report.triangles;
  facts["materials"] = report.materials;
  facts["textures"] = report.textures_found;
  facts["textures_missing"] = report.textures_missing;
  facts["extent"] = Told(report.extent_m);
  facts["skipped"] = report.skipped;
  return facts;
}

py::list Doors(const Scene& scene) {
  py::list doors;
  for (const sim::DoorLeaf& door : scene.world().doors()) {
    py::dict facts;
    facts["object"] = door.object;
    facts["hinge"] = Told(door.hinge);
    facts["axis"] = Told(door.axis);
    facts["width"] = door.width;
    facts["angle"] = door.angle;
    facts["is_open"] = door.is_open();
    facts["leads_outside"] = door.leads_outside;
    doors.append(facts);
  }
  return doors;
}

py::list Objects(const Scene& scene) {
  py::list objects;
  for (const sim::SceneObject& object : scene.world().objects()) {
    py::dict facts;
    facts["category"] = object.category;
    facts["name"] = object.name;
    facts["room"] = object.room;
    objects.append(facts);
  }
  return objects;
}

}  // namespace

void BindScene(py::module_* module) {
  const auto unlocked = py::call_guard<py::gil_scoped_release>();
  py::class_<Scene>(*module, "Scene")
      .def(py::init<const std::string&, const std::string&>(), unlocked)
      .def("snap", &Snap, unlocked)
      .def("path", &FindPath, unlocked)
      .def(
          "distance",
          [](const Scene& scene, const Point& from, const Point& to) {
            return scene.Query().GeodesicDistance(Read(from), Read(to));
          },
          unlocked)
      .def(
          "island",
          [](const Scene& scene, const Point& point) {
            return scene.Query().IslandOf(Read(point));
          },
          unlocked)
      .def(
          "random_points",
          [](const Scene& scene, int count, std::uint64_t seed, int island) {
            return Told(scene.RandomPoints(count, seed, island));
          },
          unlocked)
      .def("render", &Render)
      .def("grey", &Scene::grey)
      .def("islands", &Islands)
      .def("doors", &Doors)
      .def("objects", &Objects)
      .def("report", &Report)
      .def("renderer", [](const Scene& scene) {
        return scene.world().render_scene().description();
      });
}

}  // namespace bulletnav::python
