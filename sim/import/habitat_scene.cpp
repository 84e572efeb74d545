// SPDX-License-Identifier: MIT
#include "sim/import/habitat_scene.h"

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/base/lower_case.h"
#include "sim/base/nearest_word.h"
#include "sim/config/json_node.h"
#include "sim/import/articulated_object.h"
#include "sim/import/cpu_time.h"
#include "sim/import/habitat_dataset.h"
#include "sim/import/urdf.h"

namespace bulletnav::sim {
namespace {

using Json = nlohmann::ordered_json;
using Node = JsonNode<Json>;
using Vec = Eigen::Vector3f;
using Kind = HabitatDataset::Kind;

constexpr int kSecondsForUrdf = 1;

// What Habitat reads in a scene instance, also what makes no difference here. Users may add keys.
const std::vector<std::string> kSceneKeys = {
    "stage_instance",   "object_instances", "articulated_object_instances", "translation_origin",
    "default_lighting", "navmesh_instance", "semantic_scene_instance",      "user_defined"};
const std::vector<std::string> kInstanceKeys = {"template_name",       "translation_origin",
                                                "translation",         "rotation",
                                                "uniform_scale",       "non_uniform_scale",
                                                "mass_scale",          "motion_type",
                                                "is_instance_visible", "shader_type",
                                                "user_defined",        "apply_scale_to_mass",
                                                "fixed_base",          "base_type",
                                                "inertia_source",      "link_order",
                                                "render_mode",         "auto_clamp_joint_limits",
                                                "initial_joint_pose",  "initial_joint_velocities"};

/// Keys that are almost one of those: without a complaint, what they say would be left out.
void RefuseMisspelt(const Node& node, const std::vector<std::string>& known) {
  constexpr std::size_t kLetters = 2;
  if (!node.value().is_object()) return;
  for (const auto& [key, value] : node.value().items()) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    const std::string meant = NearestWord(key, known, kLetters);
    if (meant.empty()) continue;
    node.Fail(std::string("unknown key '").append(key) + "'; did you mean '" + meant + "'?");
  }
}

Vec ReadVector(const Node& instance, const char* key, const Vec& otherwise) {
  return instance.Has(key) ? ReadVector(instance.At(key)) : otherwise;
}

Eigen::Matrix3f ReadRotation(const Node& instance) {
  if (!instance.Has("rotation")) return Eigen::Matrix3f::Identity();
  const Node node = instance.At("rotation");
  node.ExpectList(4);
  Eigen::Vector4d q = Eigen::Vector4d::Zero();
  for (int i = 0; i < 4; ++i) q[i] = node.Item(static_cast<std::size_t>(i)).Number();
  if (!(q.norm() > 1e-6)) node.Fail("is no rotation: a quaternion w, x, y, z other than 0");
  q.normalize();
  return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix().cast<float>();
}

Vec ReadScale(const Node& instance) {
  Vec scale = ReadVector(instance, "non_uniform_scale", Vec::Ones());
  if (instance.Has("uniform_scale")) {
    scale *= static_cast<float>(instance.At("uniform_scale").Positive());
  }
  if (scale.cwiseAbs().minCoeff() < 1e-9f) instance.Fail("has a scale of 0; give it another");
  return scale;
}

/// Whether translations are those of the assets' origins; `otherwise` if not said.
bool IsAssetLocal(const Node& node, bool otherwise) {
  if (!node.Has("translation_origin")) return otherwise;
  const Node origin = node.At("translation_origin");
  const std::string text = LowerCase(origin.Text());
  if (text == "asset_local") return true;
  if (text == "com" || text == "unknown" || text == "default") return false;
  origin.Fail("'" + text + "' is not one of: asset_local, COM");
}

/// A list, or numbers by name, which count in the order of the names.
std::vector<double> ReadPositions(const Node& instance) {
  std::vector<double> positions;
  if (!instance.Has("initial_joint_pose")) return positions;
  const Node pose = instance.At("initial_joint_pose");
  if (!pose.value().is_object()) {
    for (std::size_t i = 0; i < pose.Size(); ++i) positions.push_back(pose.Item(i).Number());
    return positions;
  }
  std::map<std::string, double> by_name;
  for (const auto& [name, value] : pose.value().items()) {
    by_name[name] = pose.At(name.c_str()).Number();
  }
  for (const auto& [name, position] : by_name) positions.push_back(position);
  return positions;
}

class SceneReader {
 public:
  explicit SceneReader(const std::filesystem::path& file)
      : file_(file), json_(ParseJson<Json>(ReadTextFile(file), file)), dataset_(file) {}

  SceneParts Read() {
    const Node root(json_, file_);
    if (!json_.is_object()) root.Fail("is no scene instance; take a sound copy of the file");
    RefuseMisspelt(root, kSceneKeys);
    is_asset_local_ = IsAssetLocal(root, false);
    if (root.Has("stage_instance")) {
      Add(Kind::kStage, root.At("stage_instance"), "stage_instance");
    }
    if (root.Has("object_instances")) {
      const Node objects = root.At("object_instances");
      for (std::size_t i = 0; i < objects.Size(); ++i) {
        Add(Kind::kObject, objects.Item(i), "object_instances[" + std::to_string(i) + "]");
      }
    }
    if (root.Has("articulated_object_instances")) {
      const Node objects = root.At("articulated_object_instances");
      for (std::size_t i = 0; i < objects.Size(); ++i) {
        AddJointed(objects.Item(i), "articulated_object_instances[" + std::to_string(i) + "]");
      }
    }
    CountLeftOut();
    if (scene_.parts.empty())
      root.Fail("names no stage and no objects that show anything; is it the right file?");
    return std::move(scene_);
  }

 private:
  HabitatTemplate Find(Kind kind, const std::string& name, const std::string& place) const try {
    return dataset_.Find(kind, name);
  } catch (const Error& e) {
    throw FileError(file_, place + ".template_name", "'" + name + "': " + e.what());
  }

  void Add(Kind kind, const Node& instance, const std::string& place) {
    RefuseMisspelt(instance, kInstanceKeys);
    const std::string name = instance.At("template_name").Text();
    if (kind == Kind::kStage && name == "NONE") return;
    const HabitatTemplate made = Find(kind, name, place);
    ScenePart part;
    part.asset = made.asset;
    part.place = place;
    part.object = {kind == Kind::kStage ? "stage" : made.name, "", ""};
    const Eigen::Matrix3f turn_and_scale =
        ReadRotation(instance) * ReadScale(instance).asDiagonal();
    part.X_WA.linear() = turn_and_scale * made.turn_and_scale;
    part.X_WA.translation() = ReadVector(instance, "translation", Vec::Zero());
    if (kind == Kind::kObject && !IsAssetLocal(instance, is_asset_local_)) {
      part.is_centred = !made.center_of_mass;
      if (made.center_of_mass) part.X_WA.translation() -= turn_and_scale * *made.center_of_mass;
    }
    scene_.parts.push_back(std::move(part));
  }

  const Urdf& UrdfIn(const std::filesystem::path& urdf, const std::string& place) try {
    const auto known = urdfs_.find(urdf);
    if (known != urdfs_.end()) return known->second;
    AllowCpuSeconds(kSecondsForUrdf);
    return urdfs_.emplace(urdf, ReadUrdf(urdf)).first->second;
  } catch (const Error& e) {
    throw FileError(file_, place, std::string("its URDF is not read: ") + e.what());
  }

  /// Translations are those of root links, whatever translation_origin says.
  void AddJointed(const Node& instance, const std::string& place) {
    RefuseMisspelt(instance, kInstanceKeys);
    const HabitatTemplate made =
        Find(Kind::kArticulated, instance.At("template_name").Text(), place);
    ArticulatedObject object;
    object.category = made.name;
    object.name = made.name + "_" + std::to_string(++count_of_[made.name]);
    object.place = place;
    object.X_WR.linear() = ReadRotation(instance);
    object.X_WR.translation() = ReadVector(instance, "translation", Vec::Zero());
    object.scale = made.turn_and_scale(0, 0);
    if (instance.Has("uniform_scale")) {
      object.scale *= static_cast<float>(instance.At("uniform_scale").Positive());
    }
    object.positions = ReadPositions(instance);
    const Urdf& model = UrdfIn(made.asset, place);
    AddArticulated(model, object, &scene_);
    for (const auto& [what, count] : model.left_out) left_out_[what] += count;
  }

  void CountLeftOut() {
    for (const auto& [what, count] : left_out_) {
      scene_.skipped.push_back(std::to_string(count) + " " + what + " of articulated objects");
    }
  }

  const std::filesystem::path& file_;
  Json json_;
  HabitatDataset dataset_;
  bool is_asset_local_ = false;
  std::map<std::filesystem::path, Urdf> urdfs_;
  std::map<std::string, int> count_of_;  // articulated objects of a template
  std::map<std::string, int> left_out_;
  SceneParts scene_;
};

}  // namespace

bool IsHabitatScene(const std::filesystem::path& file) {
  return file.filename().string().ends_with(".scene_instance.json");
}

SceneParts ReadHabitatScene(const std::filesystem::path& file) {
  return SceneReader(file).Read();
}

}  // namespace bulletnav::sim
