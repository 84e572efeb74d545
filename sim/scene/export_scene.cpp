// SPDX-License-Identifier: MIT
#include "sim/scene/export_scene.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/math/rotation.h"
#include "sim/scene/export_doors.h"
#include "sim/scene/glb_writer.h"
#include "sim/scene/submesh.h"

namespace bulletnav::sim {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// What is built in, and belongs to the stage.
constexpr std::array<std::string_view, 9> kBuiltIn = {
    "", "wall", "floor", "ceiling", "beams", "pit", "door_frame", "window", "stage"};

/// A part of the scene around its own origin, the middle of its box, or its hinge.
struct Piece {
  bool is_stage = false;
  std::string name;
  SceneMesh mesh;
  Eigen::Vector3f middle = Eigen::Vector3f::Zero();
  std::optional<DoorLeaf> door = std::nullopt;  // that can be turned
};

/// Letters, digits, dashes and underscores.
std::string FileName(std::string name) {
  std::replace_if(
      name.begin(), name.end(),
      [](unsigned char c) {
        return !(std::isalnum(c) != 0 || c == '-' || c == '_');
      },
      '_');
  return name;
}

bool IsBuiltIn(const SceneObject& object) {
  return std::find(kBuiltIn.begin(), kBuiltIn.end(), object.category) != kBuiltIn.end();
}

/// The door that an object is. Doors that lead outside stay as they are.
std::optional<DoorLeaf> DoorOf(const SceneObject& object, const std::vector<DoorLeaf>& doors) {
  const auto door = std::find_if(doors.begin(), doors.end(), [&](const DoorLeaf& leaf) {
    return leaf.object == object.name && !leaf.leads_outside;
  });
  return door == doors.end() ? std::nullopt : std::optional(*door);
}

/// The stage first, where there is one, then the objects in their order.
std::vector<Piece> Pieces(const SceneMesh& mesh, const std::vector<DoorLeaf>& doors) {
  std::map<std::uint32_t, std::vector<std::size_t>> triangles_of;  // 0: the stage
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::uint32_t object = mesh.has_objects() ? mesh.triangle_objects[t] : 0;
    const bool is_stage = object == 0 || IsBuiltIn(mesh.objects[object]);
    triangles_of[is_stage ? 0 : object].push_back(t);
  }
  std::set<std::string> names;
  std::vector<Piece> pieces;
  for (const auto& [object, triangles] : triangles_of) {
    Piece piece;
    piece.is_stage = object == 0;
    piece.mesh = Submesh(mesh, triangles);
    const std::string wish = piece.is_stage ? "stage" : FileName(mesh.objects[object].name);
    piece.name = wish;
    for (int n = 2; !names.insert(piece.name).second; ++n)
      piece.name = fmt::format("{}-{}", wish, n);
    if (!piece.is_stage) {
      piece.door = DoorOf(mesh.objects[object], doors);
      piece.middle = piece.door ? piece.door->hinge : Eigen::Vector3f(piece.mesh.Bounds().center());
      for (Eigen::Vector3f& p : piece.mesh.positions) p -= piece.middle;
    }
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

void WriteJson(const fs::path& file, const Json& json) {
  WriteFileAtomically(file, json.dump(2) + "\n");
}

void WriteDatasetConfig(const fs::path& folder) {
  const auto paths = [](const char* pattern, const char* extension = ".json") {
    return Json{{"paths", {{extension, Json::array({pattern})}}}};
  };
  WriteJson(folder / "bulletnav.scene_dataset_config.json",
            {{"stages", paths("stages")},
             {"objects", paths("objects/*")},
             {"articulated_objects", paths("urdf/*", ".urdf")},
             {"scene_instances", paths("scenes")}});
}

/// The mesh and its config; returns what instances call it.
std::string WriteTemplate(const Piece& piece, const fs::path& folder, const std::string& path,
                          const std::string& kind) {
  WriteFileAtomically(folder / (path + ".glb"), EncodeGlb(piece.mesh));
  const std::string config = path + kind;
  WriteJson(folder / config, {{"render_asset", fs::path(path).filename().string() + ".glb"},
                              {"up", {0, 1, 0}},
                              {"front", {0, 0, -1}}});
  // With its whole end, for Habitat takes any template whose path contains the name.
  return config.substr(config.find('/') + 1);
}

/// The leaf as it would stand shut, and its URDF; returns what stands for it in the scene.
Json WriteJointed(const Piece& piece, const fs::path& folder, const std::string& scene) {
  const DoorLeaf& leaf = *piece.door;
  const std::string path = scene + "/" + piece.name;
  SceneMesh mesh = piece.mesh;
  const Eigen::Matrix3f back = RotationAbout<float>(leaf.axis, -leaf.angle);
  if (leaf.angle != 0.0f) {
    for (Eigen::Vector3f& p : mesh.positions) p = back * p;
  }
  WriteFileAtomically(folder / "urdf" / (path + ".glb"), EncodeGlb(mesh));
  WriteFileAtomically(folder / "urdf" / (path + ".urdf"),
                      UrdfDoor({piece.name, piece.name + ".glb", leaf}));
  const Eigen::Vector3f& p = piece.middle;
  return {{"template_name", path + ".urdf"},
          {"translation", {p.x(), p.y(), p.z()}},
          {"rotation", {1, 0, 0, 0}},
          {"fixed_base", true},
          {"initial_joint_pose", Json::array({leaf.angle})},
          {"auto_clamp_joint_limits", true},
          {"motion_type", "DYNAMIC"}};
}

fs::path WriteSceneInstance(const std::vector<Piece>& pieces, const std::string& name,
                            const fs::path& folder) {
  WriteDatasetConfig(folder);
  Json scene = {{"translation_origin", "asset_local"}};
  Json objects = Json::array();
  Json jointed = Json::array();
  for (const Piece& piece : pieces) {
    if (piece.is_stage) {
      scene["stage_instance"] = {
          {"template_name",
           "stages/" + WriteTemplate(piece, folder, "stages/" + name, ".stage_config.json")}};
      continue;
    }
    if (piece.door) {
      jointed.push_back(WriteJointed(piece, folder, name));
      continue;
    }
    const std::string path = "objects/" + name + "/" + piece.name;
    const Eigen::Vector3f& p = piece.middle;
    objects.push_back({{"template_name", WriteTemplate(piece, folder, path, ".object_config.json")},
                       {"translation", {p.x(), p.y(), p.z()}},
                       {"rotation", {1, 0, 0, 0}},
                       {"motion_type", "STATIC"}});
  }
  scene["object_instances"] = std::move(objects);
  if (!jointed.empty()) scene["articulated_object_instances"] = std::move(jointed);
  fs::path file = folder / "scenes" / (name + ".scene_instance.json");
  WriteJson(file, scene);
  return file;
}

/// y up becomes z up: a quarter turn about x. glTF is drawn in its own axes.
std::string SdfModel(const Piece& piece, const std::string& uri) {
  const Eigen::Vector3f& p = piece.middle;
  const std::string geometry = fmt::format("<geometry><mesh><uri>{}</uri></mesh></geometry>", uri);
  return fmt::format(
      "    <model name=\"{}\">\n"
      "      <static>true</static>\n"
      "      <pose>{} {} {} 1.5707963267948966 0 0</pose>\n"
      "      <link name=\"link\">\n"
      "        <visual name=\"visual\">{}</visual>\n"
      "        <collision name=\"collision\">{}</collision>\n"
      "      </link>\n"
      "    </model>\n",
      piece.name, p.x(), -p.z() + 0.0f, p.y(), geometry, geometry);
}

fs::path WriteSdf(const std::vector<Piece>& pieces, const std::string& name,
                  const fs::path& folder) {
  std::string world = fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<sdf version=\"1.7\">\n"
      "  <world name=\"{}\">\n"
      "    <light type=\"directional\" name=\"sun\">\n"
      "      <direction>-0.4 0.2 -0.9</direction>\n"
      "    </light>\n",
      name);
  for (const Piece& piece : pieces) {
    const std::string mesh = name + "/" + piece.name + ".glb";
    WriteFileAtomically(folder / mesh, EncodeGlb(piece.mesh));
    world += piece.door ? SdfDoor({piece.name, mesh, *piece.door}) : SdfModel(piece, mesh);
  }
  world += "  </world>\n</sdf>\n";
  fs::path file = folder / (name + ".sdf");
  WriteFileAtomically(file, world);
  return file;
}

}  // namespace

fs::path ExportScene(const SceneMesh& mesh, const std::string& name, SceneFormat format,
                     const fs::path& folder, const std::vector<DoorLeaf>& doors) {
  if (name.empty() || FileName(name) != name) {
    throw Error("'" + name + "' cannot name an exported scene; take letters, digits, - and _");
  }
  const std::vector<Piece> pieces = Pieces(mesh, doors);
  switch (format) {
    case SceneFormat::kSceneInstance:
      return WriteSceneInstance(pieces, name, folder);
    case SceneFormat::kSdf:
      break;
  }
  return WriteSdf(pieces, name, folder);
}

}  // namespace bulletnav::sim
