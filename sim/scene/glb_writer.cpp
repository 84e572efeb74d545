// SPDX-License-Identifier: MIT
#include "sim/scene/glb_writer.h"

#include <cmath>
#include <cstring>
#include <unordered_map>

#include <nlohmann/json.hpp>

#include "sim/base/elementary.h"

namespace bulletnav::sim {
namespace {

using Json = nlohmann::json;

constexpr int kJpegQuality = 92;
constexpr const char* kFeatures = "EXT_mesh_features";
constexpr int kFloat = 5126;
constexpr int kUnsignedInt = 5125;
constexpr int kUnsignedShort = 5123;
constexpr int kArrayBuffer = 34962;
constexpr int kElementArrayBuffer = 34963;

double LinearFromSrgb(std::uint8_t value) {
  const double x = value / 255.0;
  return x <= 0.04045 ? x / 12.92 : Pow((x + 0.055) / 1.055, 2.4);
}

/// The vertices and triangles of one material, renumbered.
struct Part {
  std::vector<std::uint32_t> vertices;  // of the whole mesh
  std::vector<float> objects;           // one a vertex
  std::vector<std::uint32_t> indices;   // into `vertices`
};

std::vector<Part> SplitByMaterial(const SceneMesh& mesh) {
  std::vector<Part> parts(mesh.materials.size());
  // Of a vertex in an object: those that objects share are there once for each.
  std::vector<std::unordered_map<std::uint64_t, std::uint32_t>> number(parts.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::size_t m = mesh.triangle_materials[t];
    const std::uint32_t object = mesh.has_objects() ? mesh.triangle_objects[t] : 0;
    for (const std::uint32_t v : mesh.triangles[t]) {
      const auto next = static_cast<std::uint32_t>(parts[m].vertices.size());
      const auto [place, is_new] = number[m].try_emplace(std::uint64_t{object} << 32 | v, next);
      parts[m].indices.push_back(place->second);
      if (!is_new) continue;
      parts[m].vertices.push_back(v);
      parts[m].objects.push_back(static_cast<float>(object));
    }
  }
  return parts;
}

class GlbEncoder {
 public:
  explicit GlbEncoder(const SceneMesh& mesh) : mesh_(mesh) {
    for (int i = 0; i < 256; ++i) {
      linear_[static_cast<std::size_t>(i)] = static_cast<std::uint16_t>(
          std::lround(65535.0 * LinearFromSrgb(static_cast<std::uint8_t>(i))));
    }
  }

  std::vector<std::uint8_t> Encode() {
    json_["asset"] = {{"version", "2.0"}, {"generator", "BulletNav"}};
    json_["extensionsUsed"] = {"KHR_materials_unlit"};
    if (mesh_.has_objects()) AddObjects();
    json_["scene"] = 0;
    json_["scenes"] = Json::array({{{"nodes", {0}}}});
    json_["nodes"] = Json::array({{{"mesh", 0}}});
    AddMaterials();
    Json primitives = Json::array();
    const std::vector<Part> parts = SplitByMaterial(mesh_);
    for (std::size_t m = 0; m < parts.size(); ++m) {
      if (!parts[m].indices.empty()) primitives.push_back(AddPrimitive(parts[m], m));
    }
    json_["meshes"] = Json::array({{{"primitives", primitives}}});
    json_["buffers"] = Json::array({{{"byteLength", binary_.size()}}});
    return Join();
  }

 private:
  void AddObjects() {
    json_["extensionsUsed"].push_back(kFeatures);
    Json& table = json_["extras"]["objects"];
    for (const SceneObject& object : mesh_.objects) {
      table.push_back(
          {{"category", object.category}, {"name", object.name}, {"room", object.room}});
    }
  }

  void AddMaterials() {  // NOLINT(readability-function-size): one table after the other
    for (const Texture& texture : mesh_.textures) {
      Image rgb(texture.image.width, texture.image.height, 3);
      for (std::size_t i = 0; i < rgb.pixels.size() / 3; ++i) {
        std::copy_n(&texture.image.pixels[4 * i], 3, &rgb.pixels[3 * i]);
      }
      const int view = AddView(EncodeJpeg(rgb, kJpegQuality), 0);
      json_["images"].push_back(
          {{"name", texture.name}, {"mimeType", "image/jpeg"}, {"bufferView", view}});
      json_["textures"].push_back({{"source", json_["images"].size() - 1}});
    }
    for (const Material& material : mesh_.materials) {
      Json pbr = {{"metallicFactor", 0.0}, {"roughnessFactor", 1.0}};
      if (material.base_color != kWhite) {
        for (const std::uint8_t c : material.base_color) {
          pbr["baseColorFactor"].push_back(LinearFromSrgb(c));
        }
        pbr["baseColorFactor"].push_back(1.0);
      }
      if (material.texture >= 0) pbr["baseColorTexture"] = {{"index", material.texture}};
      json_["materials"].push_back({{"name", material.name},
                                    {"doubleSided", true},
                                    {"pbrMetallicRoughness", pbr},
                                    {"extensions", {{"KHR_materials_unlit", Json::object()}}}});
    }
  }

  Json AddPrimitive(const Part& part, std::size_t material) {
    std::vector<float> positions;
    std::vector<float> uvs;
    std::vector<std::uint16_t> colors;
    Eigen::AlignedBox3f box;
    for (const std::uint32_t v : part.vertices) {
      const Eigen::Vector3f& p = mesh_.positions[v];
      box.extend(p);
      positions.insert(positions.end(), {p.x(), p.y(), p.z()});
      uvs.insert(uvs.end(), {mesh_.uvs[v].x(), mesh_.uvs[v].y()});
      for (const std::uint8_t c : mesh_.colors[v]) colors.push_back(linear_[c]);
      colors.push_back(65535);
    }
    const std::size_t n = part.vertices.size();
    const int position = AddAccessor(positions, kFloat, "VEC3", n, kArrayBuffer);
    Json& bounds = json_["accessors"][static_cast<std::size_t>(position)];
    bounds["min"] = {box.min().x(), box.min().y(), box.min().z()};
    bounds["max"] = {box.max().x(), box.max().y(), box.max().z()};
    Json attributes = {{"POSITION", position}};
    attributes["TEXCOORD_0"] = AddAccessor(uvs, kFloat, "VEC2", n, kArrayBuffer);
    const int color = AddAccessor(colors, kUnsignedShort, "VEC4", n, kArrayBuffer);
    json_["accessors"][static_cast<std::size_t>(color)]["normalized"] = true;
    attributes["COLOR_0"] = color;
    Json primitive = {{"material", material}};
    if (mesh_.has_objects()) {
      attributes["_FEATURE_ID_0"] = AddAccessor(part.objects, kFloat, "SCALAR", n, kArrayBuffer);
      primitive["extensions"][kFeatures]["featureIds"] =
          Json::array({{{"featureCount", mesh_.objects.size()}, {"attribute", 0}}});
    }
    primitive["attributes"] = attributes;
    primitive["indices"] =
        AddAccessor(part.indices, kUnsignedInt, "SCALAR", part.indices.size(), kElementArrayBuffer);
    return primitive;
  }

  template <class T>
  int AddAccessor(const std::vector<T>& values, int component_type, const char* type,
                  std::size_t count, int target) {
    std::vector<std::uint8_t> bytes(values.size() * sizeof(T));
    if (!bytes.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
    const int view = AddView(bytes, target);
    json_["accessors"].push_back({{"bufferView", view},
                                  {"componentType", component_type},
                                  {"type", type},
                                  {"count", count}});
    return static_cast<int>(json_["accessors"].size()) - 1;
  }

  int AddView(const std::vector<std::uint8_t>& bytes, int target) {
    Json view = {{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", bytes.size()}};
    if (target != 0) view["target"] = target;
    json_["bufferViews"].push_back(view);
    binary_.insert(binary_.end(), bytes.begin(), bytes.end());
    binary_.resize((binary_.size() + 3) / 4 * 4, 0);
    return static_cast<int>(json_["bufferViews"].size()) - 1;
  }

  std::vector<std::uint8_t> Join() const {
    std::string text = json_.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::vector<std::uint8_t> out;
    const auto put = [&out](std::size_t word) {
      for (unsigned shift = 0; shift < 32; shift += 8) {
        out.push_back(static_cast<std::uint8_t>(word >> shift));
      }
    };
    put(0x46546C67);  // "glTF"
    put(2);
    put(12 + 8 + text.size() + 8 + binary_.size());
    put(text.size());
    put(0x4E4F534A);  // "JSON"
    out.insert(out.end(), text.begin(), text.end());
    put(binary_.size());
    put(0x004E4942);  // "BIN"
    out.insert(out.end(), binary_.begin(), binary_.end());
    return out;
  }

  const SceneMesh& mesh_;
  std::array<std::uint16_t, 256> linear_{};
  Json json_;
  std::vector<std::uint8_t> binary_;
};

}  // namespace

std::vector<std::uint8_t> EncodeGlb(const SceneMesh& mesh) {
  return GlbEncoder(mesh).Encode();
}

}  // namespace bulletnav::sim
