// SPDX-License-Identifier: MIT
#include "sim/import/habitat_dataset.h"

#include <algorithm>
#include <string_view>

#include <glob.h>

#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/config/json_node.h"

namespace bulletnav::sim {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Node = JsonNode<Json>;
using Vec = Eigen::Vector3f;

constexpr std::string_view kDatasetEnd = ".scene_dataset_config.json";
constexpr int kMostFoldersUp = 8;

/// What is written about templates of a kind.
struct KindText {
  const char* key;    // in the data set's file
  const char* end;    // of files of attributes
  const char* asset;  // the attribute that names what is drawn
};

KindText TextOf(HabitatDataset::Kind kind) {
  switch (kind) {
    case HabitatDataset::Kind::kStage:
      return {"stages", ".stage_config.json", "render_asset"};
    case HabitatDataset::Kind::kObject:
      return {"objects", ".object_config.json", "render_asset"};
    case HabitatDataset::Kind::kArticulated:
      break;
  }
  return {"articulated_objects", ".ao_config.json", "urdf_filepath"};
}

/// Files and folders that a pattern below `folder` names, in the order of their names.
std::vector<fs::path> Expand(const fs::path& folder, const std::string& pattern) {
  std::string escaped;
  for (const char c : folder.string()) {
    if (std::string_view("*?[]\\").find(c) != std::string_view::npos) escaped += '\\';
    escaped += c;
  }
  glob_t found = {};
  std::vector<fs::path> paths;
  if (::glob((escaped + "/" + pattern).c_str(), 0, nullptr, &found) == 0) {
    for (std::size_t i = 0; i < found.gl_pathc; ++i) paths.emplace_back(found.gl_pathv[i]);
  }
  ::globfree(&found);
  std::sort(paths.begin(), paths.end());
  return paths;
}

/// Files that end so: `place` itself, or in it.
void AppendFiles(const fs::path& place, const std::string& end, std::vector<fs::path>* files) {
  std::error_code unreadable;
  if (!fs::is_directory(place, unreadable)) {
    if (place.string().ends_with(end)) files->push_back(place);
    return;
  }
  std::vector<fs::path> inside;
  for (const fs::directory_entry& entry : fs::directory_iterator(place, unreadable)) {
    if (entry.path().string().ends_with(end)) inside.push_back(entry.path());
  }
  std::sort(inside.begin(), inside.end());
  files->insert(files->end(), inside.begin(), inside.end());
}

/// Files ending in `end` below a data set's `paths` of one extension.
std::vector<fs::path> FilesOf(const Node& patterns, const fs::path& folder,
                              const std::string& end) {
  std::vector<fs::path> files;
  for (std::size_t i = 0; i < patterns.Size(); ++i) {
    for (const fs::path& place : Expand(folder, patterns.Item(i).Text())) {
      AppendFiles(place, end, &files);
    }
  }
  return files;
}

std::string WithoutEnd(const std::string& path, std::string_view end) {
  return path.ends_with(end) ? path.substr(0, path.size() - end.size()) : path;
}

/// Attributes with what is drawn as a whole path: it is relative to the file that has it.
Json WithAsset(Json attributes, const fs::path& folder, const char* key) {
  const auto asset = attributes.find(key);
  if (asset != attributes.end() && asset->is_string()) {
    *asset = (folder / asset->get<std::string>()).lexically_normal().string();
  }
  return attributes;
}

void Override(const Json& with, Json* attributes) {
  for (const auto& [key, value] : with.items()) (*attributes)[key] = value;
}

/// From axes with that up and front to +y and -z.
Eigen::Matrix3f TurnOf(const Node& attributes) {
  const Vec up = attributes.Has("up") ? ReadVector(attributes.At("up")) : Vec::UnitY();
  const Vec usual = std::abs(up.z()) > 0.5f * up.norm() ? Vec::UnitY() : Vec(-Vec::UnitZ());
  const Vec front = attributes.Has("front") ? ReadVector(attributes.At("front")) : usual;
  if (!(up.norm() > 1e-6f && front.norm() > 1e-6f &&
        std::abs(up.normalized().dot(front.normalized())) < 1e-3f)) {
    attributes.Fail("'up' and 'front' are not at right angles; mend them");
  }
  Eigen::Matrix3f turn;
  turn.row(1) = up.normalized();
  turn.row(2) = -front.normalized();
  turn.row(0) = turn.row(1).cross(turn.row(2));
  return turn;
}

HabitatTemplate ReadArticulated(const Node& attributes) {
  HabitatTemplate made;
  if (!attributes.Has("urdf_filepath")) {
    attributes.Fail("'urdf_filepath', the URDF to read, is missing; add it");
  }
  made.asset = attributes.At("urdf_filepath").Text();
  if (attributes.Has("uniform_scale")) {
    made.turn_and_scale *= static_cast<float>(attributes.At("uniform_scale").Positive());
  }
  return made;
}

HabitatTemplate ReadTemplate(const Node& attributes) {
  HabitatTemplate made;
  if (!attributes.Has("render_asset")) {
    attributes.Fail("'render_asset', the mesh to draw, is missing; add it");
  }
  made.asset = attributes.At("render_asset").Text();
  Vec scale = attributes.Has("scale") ? ReadVector(attributes.At("scale")) : Vec::Ones();
  if (attributes.Has("units_to_meters")) {
    scale *= static_cast<float>(attributes.At("units_to_meters").Positive());
  }
  made.turn_and_scale = scale.asDiagonal() * TurnOf(attributes);
  if (attributes.Has("COM")) {
    made.center_of_mass = scale.cwiseProduct(ReadVector(attributes.At("COM")));
  }
  return made;
}

}  // namespace

Eigen::Vector3f ReadVector(const JsonNode<nlohmann::ordered_json>& node) {
  node.ExpectList(3);
  Vec v = Vec::Zero();
  for (int i = 0; i < 3; ++i) {
    v[i] = static_cast<float>(node.Item(static_cast<std::size_t>(i)).Number());
  }
  return v;
}

HabitatDataset::HabitatDataset(const fs::path& scene) {
  std::error_code ignored;
  fs::path folder = fs::absolute(scene, ignored).lexically_normal().parent_path();
  for (int i = 0; i < kMostFoldersUp; ++i, folder = folder.parent_path()) {
    std::vector<fs::path> configs;
    AppendFiles(folder, std::string(kDatasetEnd), &configs);
    for (const fs::path& config : configs) {
      file_ = config;
      json_ = ParseJson<Json>(ReadTextFile(config), config);
      if (!Lists(scene)) continue;
      stages_ = EntriesOf(Kind::kStage);
      objects_ = EntriesOf(Kind::kObject);
      articulated_ = EntriesOf(Kind::kArticulated);
      return;
    }
    if (folder == folder.parent_path()) break;
  }
  throw FileError(scene, "",
                  "is of no data set: no *.scene_dataset_config.json in its folder or those above "
                  "lists it under scene_instances; put it where the data set has it");
}

bool HabitatDataset::Lists(const fs::path& scene) const {
  const Node root(json_, file_);
  if (!root.Has("scene_instances") || !root.At("scene_instances").Has("paths")) return false;
  const Node paths = root.At("scene_instances").At("paths");
  if (!paths.Has(".json")) return false;
  const auto files = FilesOf(paths.At(".json"), file_.parent_path(), ".scene_instance.json");
  return std::any_of(files.begin(), files.end(), [&](const fs::path& file) {
    std::error_code ignored;
    return file.filename() == scene.filename() && fs::equivalent(file, scene, ignored);
  });
}

std::vector<HabitatDataset::Entry> HabitatDataset::EntriesOf(Kind kind) const {
  std::vector<Entry> entries;
  const Node root(json_, file_);
  if (!root.Has(TextOf(kind).key)) return entries;
  const Node section = root.At(TextOf(kind).key);
  const auto add_files = [&](const Node& patterns, const std::string& end, bool is_asset) {
    for (const fs::path& file : FilesOf(patterns, file_.parent_path(), end)) {
      entries.push_back({WithoutEnd(file.generic_string(), end), file, is_asset, Json::object()});
    }
  };
  if (section.Has("paths")) {
    const Node paths = section.At("paths");
    for (const auto& [extension, patterns] : paths.value().items()) {
      const bool is_asset = extension != ".json";
      add_files(paths.At(extension.c_str()), is_asset ? extension : TextOf(kind).end, is_asset);
    }
  }
  if (section.Has("configs")) AddConfigs(section.At("configs").value(), kind, &entries);
  return entries;
}

void HabitatDataset::AddConfigs(const Json& configs, Kind kind, std::vector<Entry>* entries) const {
  const KindText text = TextOf(kind);
  const Node list(configs, file_, std::string(text.key) + ".configs");
  for (std::size_t i = 0; i < list.Size(); ++i) {
    const Node config = list.Item(i);
    Entry entry{"", "", false, Json::object()};
    if (config.Has("original_file")) {
      entry.file = file_.parent_path() / config.At("original_file").Text();
      entry.handle = WithoutEnd(entry.file.generic_string(), text.end);
    }
    if (config.Has("template_handle")) entry.handle = config.At("template_handle").Text();
    if (config.Has("attributes")) {
      entry.overrides = WithAsset(config.At("attributes").value(), file_.parent_path(), text.asset);
    }
    entries->push_back(std::move(entry));
  }
}

HabitatTemplate HabitatDataset::Load(Kind kind, const Entry& entry) const {
  Json attributes = Json::object();
  const KindText text = TextOf(kind);
  const Node section = Node(json_, file_).At(text.key);
  const auto add = [&](const Json& more, const fs::path& folder) {
    Override(WithAsset(more, folder, text.asset), &attributes);
  };
  if (section.Has("default_attributes")) {
    add(section.At("default_attributes").value(), file_.parent_path());
  }
  if (entry.is_asset) {
    attributes[text.asset] = entry.file.string();
  } else if (!entry.file.empty()) {
    const Json own = ParseJson<Json>(ReadTextFile(entry.file), entry.file);
    if (!own.is_object()) throw FileError(entry.file, "", "is no JSON object; mend it");
    // A URDF that is not named has the name of its attributes' file.
    if (kind == Kind::kArticulated) {
      attributes[text.asset] = WithoutEnd(entry.file.string(), text.end) + ".urdf";
    }
    add(own, entry.file.parent_path());
  }
  Override(entry.overrides, &attributes);
  const Node all(attributes, entry.file.empty() ? file_ : entry.file);
  HabitatTemplate made = kind == Kind::kArticulated ? ReadArticulated(all) : ReadTemplate(all);
  made.name = fs::path(entry.handle).filename().string();
  return made;
}

const std::vector<HabitatDataset::Entry>& HabitatDataset::entries(Kind kind) const {
  switch (kind) {
    case Kind::kStage:
      return stages_;
    case Kind::kObject:
      return objects_;
    case Kind::kArticulated:
      break;
  }
  return articulated_;
}

HabitatTemplate HabitatDataset::Find(Kind kind, const std::string& name) const {
  const KindText text = TextOf(kind);
  const std::string wanted = WithoutEnd(name, text.end);
  const auto is_named = [&](const Entry& entry) {
    return entry.handle == wanted || entry.handle.ends_with("/" + wanted) ||
           (entry.is_asset && (entry.handle + entry.file.extension().string()).ends_with(wanted));
  };
  const auto has_part = [&](const Entry& entry) {
    return fs::path(entry.handle).filename().string().find(wanted) != std::string::npos;
  };
  std::vector<const Entry*> found;
  for (const Entry& entry : entries(kind)) {
    if (!wanted.empty() && is_named(entry)) found.push_back(&entry);
  }
  if (found.empty() && !wanted.empty()) {
    for (const Entry& entry : entries(kind)) {
      if (has_part(entry)) found.push_back(&entry);
    }
  }
  // What has attributes is meant rather than the bare mesh beside it.
  const bool has_attributes = std::any_of(found.begin(), found.end(), [](const Entry* entry) {
    return !entry->is_asset;
  });
  if (has_attributes)
    std::erase_if(found, [](const Entry* entry) {
      return entry->is_asset;
    });
  if (found.empty()) {
    throw Error("none of the " + std::to_string(entries(kind).size()) + " " + text.key + " that " +
                file_.string() + " lists is called so; mend the name, or download what is missing");
  }
  if (found.size() > 1) {
    throw Error("may be " + found[0]->handle + " or " + found[1]->handle +
                "; write more of the path");
  }
  return Load(kind, *found[0]);
}

}  // namespace bulletnav::sim
