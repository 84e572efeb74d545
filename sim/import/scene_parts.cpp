// SPDX-License-Identifier: MIT
#include "sim/import/scene_parts.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/import/assimp_scene.h"
#include "sim/import/cpu_time.h"
#include "sim/import/load_textures.h"
#include "sim/import/mesh_file_check.h"
#include "sim/import/mesh_io.h"

namespace bulletnav::sim {
namespace {

constexpr std::size_t kMostTriangles = 100'000'000;
constexpr std::size_t kTrianglesASecond = 1'000'000;

/// How much larger the asset gets; its textures are kept as fine as that shows them.
float LargestScale(const ScenePart& part) {
  return part.X_WA.linear().colwise().norm().maxCoeff();
}

/// An asset as it is in its file, with its place among the materials and textures of the scene.
struct Asset {
  SceneMesh mesh;  // without textures when they have been moved into the scene
  std::uint32_t first_material = 0;
};

/// A rectangle, no larger than reaches 1 m beyond a box.
ScenePart CutOff(const ScenePart& plane, const Eigen::AlignedBox3f& others) {
  ScenePart cut = plane;
  Eigen::AlignedBox3f box = others.transformed(plane.X_WA.inverse());
  box.min().array() -= 1.0f;
  box.max().array() += 1.0f;
  for (Eigen::Vector3f& p : cut.mesh.positions) {
    p.head<2>() = p.head<2>().cwiseMax(box.min().head<2>()).cwiseMin(box.max().head<2>());
  }
  return cut;
}

class Joiner {
 public:
  Joiner(const std::filesystem::path& scene, const SceneParts& parts)
      : scene_(scene), parts_(parts), object_of_door_(parts.doors.size(), 0) {
    joined_.objects.emplace_back();
    // Of one asset, the largest copy is seen from nearest.
    for (const ScenePart& part : parts_.parts) {
      float& scale = scale_of_[KeyOf(part)];
      scale = std::max(scale, LargestScale(part));
    }
  }

  ImportedScene Join() {
    for (const ScenePart& part : parts_.parts) {
      if (!part.ends_with_scene) Add(part);
    }
    const Eigen::AlignedBox3f others = joined_.Bounds();
    for (const ScenePart& part : parts_.parts) {
      if (part.ends_with_scene) Add(others.isEmpty() ? part : CutOff(part, others));
    }
    for (const auto& [line, count] : skipped_) {
      report_.skipped.push_back(count == 1 ? line
                                           : line + " (in " + std::to_string(count) + " meshes)");
    }
    report_.skipped.insert(report_.skipped.end(), parts_.skipped.begin(), parts_.skipped.end());
    report_.textures_found = joined_.textures.size();
    for (std::size_t i = 0; i < parts_.doors.size(); ++i) {
      if (object_of_door_[i] == 0) continue;
      all_.doors.push_back(parts_.doors[i]);
      all_.doors.back().object = joined_.objects[object_of_door_[i]].name;
    }
    return std::move(all_);
  }

 private:
  using Key = std::pair<std::string, bool>;
  static Key KeyOf(const ScenePart& part) { return {part.asset.string(), part.keeps_axes}; }

  void Add(const ScenePart& part) {
    if (part.asset.empty()) {
      Asset own{part.mesh};
      TakeMaterials(&own);
      Place(part, own);
      return;
    }
    const Key key = KeyOf(part);
    auto found = assets_.find(key);
    if (found == assets_.end()) found = assets_.emplace(key, Read(part, scale_of_[key])).first;
    Place(part, found->second);
  }

  Asset Read(const ScenePart& part, float scale) try {
    AllowCpuSeconds(SecondsToRead(part.asset));
    const CheckedMeshFile checked = CheckMeshFile(part.asset);
    const AssimpScene source(part.asset, checked, part.keeps_axes);
    Asset asset;
    ImportReport own;
    own.skipped = checked.ignored;
    asset.mesh = source.Convert(&own);
    if (checked.objects.of_triangles.size() == asset.mesh.triangles.size()) {
      asset.mesh.objects = checked.objects.objects;
      asset.mesh.triangle_objects = checked.objects.of_triangles;
    }
    SceneMesh& mesh = asset.mesh;
    const std::vector<Eigen::Vector3f> as_in_file = mesh.positions;
    for (Eigen::Vector3f& p : mesh.positions) p *= scale;
    LoadTextures(source, &mesh, &own);
    mesh.positions = as_in_file;
    for (const std::string& missing : own.textures_missing) {
      report_.textures_missing.push_back(part.asset.filename().string() + ", " + missing);
    }
    for (const std::string& line : own.skipped) ++skipped_[line];
    TakeMaterials(&asset);
    return asset;
  } catch (const Error& e) {
    throw FileError(scene_, part.place, std::string("its mesh is not read: ") + e.what());
  }

  /// Moves materials and textures into the scene.
  void TakeMaterials(Asset* asset) {
    std::vector<int> numbers;
    for (Texture& texture : asset->mesh.textures) numbers.push_back(NumberOf(std::move(texture)));
    asset->mesh.textures.clear();
    asset->first_material = static_cast<std::uint32_t>(joined_.materials.size());
    for (Material material : asset->mesh.materials) {
      if (material.texture >= 0) {
        material.texture = numbers[static_cast<std::size_t>(material.texture)];
      }
      joined_.materials.push_back(std::move(material));
    }
  }

  /// Assets that come in files of their own have many a picture in common.
  int NumberOf(Texture texture) {
    std::vector<int>& alike = textures_[Hash64(texture.image.pixels)];
    for (const int i : alike) {
      const Image& image = joined_.textures[static_cast<std::size_t>(i)].image;
      if (image.width == texture.image.width && image.pixels == texture.image.pixels) return i;
    }
    alike.push_back(static_cast<int>(joined_.textures.size()));
    joined_.textures.push_back(std::move(texture));
    return alike.back();
  }

  void Place(const ScenePart& part, const Asset& asset) {
    const SceneMesh& mesh = asset.mesh;
    if (joined_.triangles.size() + mesh.triangles.size() > kMostTriangles) {
      throw FileError(scene_, part.place,
                      "brings the scene above 100 million triangles; take some objects out");
    }
    AllowCpuSeconds(1 + static_cast<int>(mesh.triangles.size() / kTrianglesASecond));
    const auto base = static_cast<std::uint32_t>(joined_.positions.size());
    const Eigen::Vector3f middle =
        part.is_centred ? Eigen::Vector3f(mesh.Bounds().center()) : Eigen::Vector3f::Zero();
    for (const Eigen::Vector3f& p : mesh.positions) {
      joined_.positions.push_back(part.X_WA * (p - middle));
    }
    joined_.uvs.insert(joined_.uvs.end(), mesh.uvs.begin(), mesh.uvs.end());
    joined_.colors.insert(joined_.colors.end(), mesh.colors.begin(), mesh.colors.end());
    for (const auto& [a, b, c] : mesh.triangles) {
      joined_.triangles.push_back({base + a, base + b, base + c});
    }
    for (const std::uint32_t m : mesh.triangle_materials) {
      joined_.triangle_materials.push_back(asset.first_material + m);
    }
    PlaceObjects(part, mesh);
  }

  /// What the first part of a door shows is what the door is called.
  void PlaceDoor(const ScenePart& part, const SceneMesh& mesh) {
    std::uint32_t& object = object_of_door_[static_cast<std::size_t>(part.door)];
    if (object == 0) {
      const std::uint32_t own = mesh.has_objects() ? mesh.triangle_objects.front() : 0;
      object = AddObject(own == 0 ? part.object : mesh.objects[own]);
    }
    joined_.triangle_objects.insert(joined_.triangle_objects.end(), mesh.triangles.size(), object);
  }

  void PlaceObjects(const ScenePart& part, const SceneMesh& mesh) {
    if (part.door >= 0) {
      PlaceDoor(part, mesh);
      return;
    }
    if (!mesh.has_objects()) {
      const std::string& name = part.object.name;
      const auto known = object_of_part_.find(name);
      const bool is_known = !name.empty() && known != object_of_part_.end();
      const std::uint32_t object = is_known ? known->second : AddObject(part.object);
      if (!name.empty()) object_of_part_[name] = object;
      joined_.triangle_objects.insert(joined_.triangle_objects.end(), mesh.triangles.size(),
                                      object);
      return;
    }
    std::map<std::uint32_t, std::uint32_t> numbers;  // the file's to the scene's
    for (const std::uint32_t old : mesh.triangle_objects) {
      const auto [place, is_new] = numbers.try_emplace(old, 0);
      if (is_new) place->second = AddObject(mesh.objects[old]);
      joined_.triangle_objects.push_back(place->second);
    }
  }

  std::uint32_t AddObject(SceneObject object) {
    if (object == SceneObject()) return 0;
    const std::string wish = object.name.empty() ? object.category : object.name;
    if (object.name.empty()) object.name = wish + "_1";
    for (int& n = count_of_[wish]; !names_.insert(object.name).second;) {
      n = std::max(n, 1) + 1;
      object.name = wish + "_" + std::to_string(n);
    }
    joined_.objects.push_back(std::move(object));
    return static_cast<std::uint32_t>(joined_.objects.size()) - 1;
  }

  const std::filesystem::path& scene_;
  const SceneParts& parts_;
  ImportedScene all_;
  SceneMesh& joined_ = all_.mesh;
  ImportReport& report_ = all_.report;
  std::map<Key, float> scale_of_;
  std::map<Key, Asset> assets_;
  std::map<std::string, int> skipped_;
  std::map<std::uint64_t, std::vector<int>> textures_;  // by the hash of their pixels
  std::map<std::string, int> count_of_;                 // of names wished for
  std::set<std::string> names_;
  std::map<std::string, std::uint32_t> object_of_part_;  // by the name that parts have
  std::vector<std::uint32_t> object_of_door_;            // 0: no part of it has come
};

}  // namespace

ImportedScene JoinParts(const std::filesystem::path& scene, const SceneParts& parts) {
  return Joiner(scene, parts).Join();
}

}  // namespace bulletnav::sim
