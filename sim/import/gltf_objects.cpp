// SPDX-License-Identifier: MIT
#include "sim/import/gltf_objects.h"

#include <bit>
#include <cmath>
#include <optional>
#include <string>

namespace bulletnav::sim {
namespace {

using Json = GltfDocument::Json;
using Bytes = GltfDocument::Bytes;

constexpr std::uint64_t kFloat = 5126;
constexpr std::uint64_t kUnsignedInt = 5125;
constexpr std::size_t kSize = 4;  // bytes of either

std::string TextOf(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

std::vector<SceneObject> TableOf(const Json& document) {
  std::vector<SceneObject> table;
  const auto extras = document.find("extras");
  if (extras == document.end() || !extras->is_object()) return table;
  const auto list = extras->find("objects");
  if (list == extras->end() || !list->is_array()) return table;
  for (const Json& object : *list) {
    if (!object.is_object()) return {};
    table.push_back({TextOf(object, "category"), TextOf(object, "name"), TextOf(object, "room")});
  }
  return table;
}

class ObjectReader {
 public:
  ObjectReader(const GltfDocument& gltf, std::span<const Bytes> views)
      : gltf_(gltf), views_(views) {}

  FileObjects Read() {
    FileObjects read;
    read.objects = TableOf(gltf_.json());
    if (read.objects.empty() || !HasOneMesh()) return {};
    for (const Json& primitive : gltf_.Item("meshes", 0).at("primitives")) {
      if (!Append(primitive, read.objects.size(), &read.of_triangles)) return {};
    }
    return read;
  }

 private:
  /// Then its triangles are the scene's, in their order.
  bool HasOneMesh() const {
    return gltf_.Array("meshes").size() == 1 && gltf_.Array("nodes").size() == 1;
  }

  /// The values of a tightly packed accessor of one component of that type.
  std::optional<Bytes> Packed(const Json& owner, const char* key, std::uint64_t type,
                              const std::string& place) const {
    const auto i = gltf_.Reference(owner, key, "accessors", place);
    if (!i) return std::nullopt;
    const Json& accessor = gltf_.Item("accessors", *i);
    const auto view = gltf_.Reference(accessor, "bufferView", "bufferViews", place);
    if (!view || accessor.contains("sparse") || TextOf(accessor, "type") != "SCALAR" ||
        gltf_.Count(accessor, "componentType", place) != type ||
        gltf_.Count(gltf_.Item("bufferViews", *view), "byteStride", place, kSize) != kSize) {
      return std::nullopt;
    }
    const std::uint64_t count = gltf_.Count(accessor, "count", place);
    if (count == 0) return Bytes();
    const std::uint64_t offset = gltf_.Count(accessor, "byteOffset", place, 0);
    return views_[*view].subspan(offset, kSize * count);
  }

  bool Append(const Json& primitive, std::size_t objects,
              std::vector<std::uint32_t>* of_triangles) const {
    const std::string place = "meshes[0].primitives";
    constexpr std::uint64_t kTriangles = 4;
    if (gltf_.Count(primitive, "mode", place, kTriangles) != kTriangles) return false;
    const auto ids = Packed(primitive.at("attributes"), "_FEATURE_ID_0", kFloat, place);
    const auto indices = Packed(primitive, "indices", kUnsignedInt, place);
    if (!ids || !indices) return false;
    for (std::size_t at = 0; at + 3 * kSize <= indices->size(); at += 3 * kSize) {
      const std::size_t vertex = ReadUint(*indices, at, kSize);
      const auto id =
          std::bit_cast<float>(static_cast<std::uint32_t>(ReadUint(*ids, kSize * vertex, kSize)));
      if (!(id >= 0.0f && id < static_cast<float>(objects))) {
        gltf_.Fail(place, "has a feature id that is no object's");
      }
      of_triangles->push_back(static_cast<std::uint32_t>(std::lround(std::floor(id))));
    }
    return true;
  }

  const GltfDocument& gltf_;
  std::span<const Bytes> views_;
};

}  // namespace

FileObjects ReadGltfObjects(const GltfDocument& gltf, std::span<const Bytes> views) {
  return ObjectReader(gltf, views).Read();
}

}  // namespace bulletnav::sim
