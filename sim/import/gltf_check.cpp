// SPDX-License-Identifier: MIT
#include "sim/import/gltf_check.h"

#include <deque>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/import/gltf_document.h"
#include "sim/import/gltf_objects.h"
#include "sim/import/mesh_file_check.h"
#include "sim/import/uri.h"

namespace bulletnav::sim {
namespace {

using Json = GltfDocument::Json;
using Bytes = GltfDocument::Bytes;

std::string Place(const char* list, std::size_t i) {
  return GltfDocument::Place(list, i);
}

class GltfChecker {
 public:
  GltfChecker(const std::filesystem::path& file, Bytes bytes) : file_(file), gltf_(file, bytes) {}

  void Check(CheckedMeshFile* checked) {
    for (std::size_t i = 0; i < gltf_.Array("buffers").size(); ++i) CheckBuffer(i);
    for (std::size_t i = 0; i < gltf_.Array("bufferViews").size(); ++i) CheckBufferView(i);
    for (std::size_t i = 0; i < gltf_.Array("accessors").size(); ++i) CheckAccessor(i);
    for (std::size_t i = 0; i < gltf_.Array("meshes").size(); ++i) CheckMesh(i);
    for (std::size_t i = 0; i < gltf_.Array("images").size(); ++i) CheckImage(i);
    CheckReferences();
    CheckNodes();
    CheckMaterials(&checked->ignored);
    checked->objects = ReadGltfObjects(gltf_, view_data_);
    checked->content = gltf_.WithIntegers();
  }

 private:
  void CheckBuffer(std::size_t i) {
    const Json& buffer = gltf_.Item("buffers", i);
    const std::string place = Place("buffers", i);
    const std::uint64_t length = gltf_.Count(buffer, "byteLength", place);
    const Bytes data = BufferData(buffer, i, place);
    if (length > data.size()) {
      gltf_.Fail(place, "needs " + std::to_string(length) + " bytes of which " + Holder(buffer) +
                            " holds " + std::to_string(data.size()));
    }
    buffer_data_.push_back(data.first(length));
  }

  Bytes BufferData(const Json& buffer, std::size_t i, const std::string& place) {
    const auto uri = buffer.find("uri");
    if (uri == buffer.end()) return i == 0 ? gltf_.binary() : Bytes();
    if (!uri->is_string()) gltf_.Fail(place + ".uri", "is not a text");
    const auto& name = uri->get_ref<const std::string&>();
    if (name.starts_with("data:")) {
      const auto& data = loaded_.emplace_back(DecodeDataUri(name));
      if (!data) gltf_.Fail(place + ".uri", "is not base64");
      return *data;
    }
    const auto path = FindByUri(file_.parent_path(), name);
    if (!path) throw FileError(file_, place, "needs '" + name + "', which is not beside it");
    return *loaded_.emplace_back(ReadFile(*path));
  }

  /// Of a buffer that BufferData could read.
  static std::string Holder(const Json& buffer) {
    const auto uri = buffer.find("uri");
    if (uri == buffer.end()) return "the file";
    const auto& name = uri->get_ref<const std::string&>();
    return name.starts_with("data:") ? "its data URI" : "'" + name + "'";
  }

  void CheckBufferView(std::size_t i) {
    const Json& view = gltf_.Item("bufferViews", i);
    const std::string place = Place("bufferViews", i);
    const auto buffer = gltf_.Reference(view, "buffer", "buffers", place);
    if (!buffer) gltf_.Fail(place, "has no 'buffer'");
    const std::uint64_t offset = gltf_.Count(view, "byteOffset", place, 0);
    const std::uint64_t length = gltf_.Count(view, "byteLength", place);
    const Bytes data = buffer_data_[*buffer];
    if (offset + length > data.size()) gltf_.Fail(place, "runs past the end of its buffer");
    view_data_.push_back(data.subspan(offset, length));
  }

  std::size_t ComponentSize(const Json& accessor, const std::string& place) const {
    switch (gltf_.Count(accessor, "componentType", place)) {
      case 5120:
      case 5121:
        return 1;
      case 5122:
      case 5123:
        return 2;
      case 5125:
      case 5126:
        return 4;
      default:
        gltf_.Fail(place + ".componentType", "is not one of glTF's");
    }
  }

  std::size_t Components(const Json& accessor, const std::string& place) const {
    static const std::map<std::string, std::size_t> components = {
        {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4},
        {"MAT2", 4},   {"MAT3", 9}, {"MAT4", 16}};
    const auto type = accessor.find("type");
    if (type == accessor.end() || !type->is_string()) gltf_.Fail(place, "has no 'type'");
    const auto found = components.find(type->get<std::string>());
    if (found == components.end()) gltf_.Fail(place + ".type", "is not one of glTF's");
    return found->second;
  }

  void CheckAccessor(std::size_t i) {
    const Json& accessor = gltf_.Item("accessors", i);
    const std::string place = Place("accessors", i);
    const std::uint64_t count = gltf_.Count(accessor, "count", place);
    const std::size_t size = ComponentSize(accessor, place) * Components(accessor, place);
    const auto view = gltf_.Reference(accessor, "bufferView", "bufferViews", place);
    if (!view || count == 0) return;
    const Json& view_json = gltf_.Item("bufferViews", *view);
    const std::uint64_t stride =
        gltf_.Count(view_json, "byteStride", Place("bufferViews", *view), size);
    if (stride < size) gltf_.Fail(place, "overlaps itself");
    const std::uint64_t offset = gltf_.Count(accessor, "byteOffset", place, 0);
    const std::size_t room = view_data_[*view].size();
    if (offset + size > room || count - 1 > (room - offset - size) / stride) {
      gltf_.Fail(place, "runs past the end of its buffer view");
    }
  }

  void CheckMesh(std::size_t i) {
    const Json& mesh = gltf_.Item("meshes", i);
    const auto primitives = mesh.find("primitives");
    if (primitives == mesh.end() || !primitives->is_array()) {
      gltf_.Fail(Place("meshes", i), "has no list of primitives");
    }
    for (std::size_t k = 0; k < primitives->size(); ++k) {
      const std::string place = Place("meshes", i) + ".primitives[" + std::to_string(k) + "]";
      const Json& primitive = (*primitives)[k];
      if (!primitive.is_object()) gltf_.Fail(place, "is not an object");
      CheckPrimitive(primitive, place);
    }
  }

  void CheckPrimitive(const Json& primitive, const std::string& place) {
    gltf_.Reference(primitive, "material", "materials", place);
    const auto attributes = primitive.find("attributes");
    if (attributes == primitive.end() || !attributes->is_object()) {
      gltf_.Fail(place, "has no attributes");
    }
    std::optional<std::uint64_t> vertices;
    for (const auto& [name, unused] : attributes->items()) {
      const auto accessor = gltf_.Reference(*attributes, name.c_str(), "accessors", place);
      const std::uint64_t count = gltf_.Count(gltf_.Item("accessors", *accessor), "count", place);
      if (vertices.value_or(count) != count) {
        gltf_.Fail(place, "has attributes of different lengths");
      }
      vertices = count;
    }
    const auto indices = gltf_.Reference(primitive, "indices", "accessors", place);
    if (indices) CheckIndices(*indices, vertices.value_or(0), place);
  }

  void CheckIndices(std::size_t i, std::uint64_t vertices, const std::string& place) const {
    const Json& accessor = gltf_.Item("accessors", i);
    const auto view = gltf_.Reference(accessor, "bufferView", "bufferViews", place);
    if (!view || accessor.contains("sparse")) return;
    const std::string name = Place("accessors", i);
    const std::size_t size = ComponentSize(accessor, name);
    const std::uint64_t offset = gltf_.Count(accessor, "byteOffset", name, 0);
    const std::uint64_t stride = gltf_.Count(gltf_.Item("bufferViews", *view), "byteStride",
                                             Place("bufferViews", *view), size);
    const std::uint64_t count = gltf_.Count(accessor, "count", name);
    for (std::uint64_t k = 0; k < count; ++k) {
      const std::uint64_t index = ReadUint(view_data_[*view], offset + k * stride, size);
      if (index < vertices) continue;
      gltf_.Fail(place, "index " + std::to_string(k) + " is vertex " + std::to_string(index) +
                            " of " + std::to_string(vertices));
    }
  }

  void CheckImage(std::size_t i) const {
    gltf_.Reference(gltf_.Item("images", i), "bufferView", "bufferViews", Place("images", i));
  }

  void CheckReferences() const {
    for (std::size_t i = 0; i < gltf_.Array("textures").size(); ++i) {
      gltf_.Reference(gltf_.Item("textures", i), "source", "images", Place("textures", i));
      gltf_.Reference(gltf_.Item("textures", i), "sampler", "samplers", Place("textures", i));
    }
    gltf_.Reference(gltf_.json(), "scene", "scenes", "document");
    for (std::size_t i = 0; i < gltf_.Array("scenes").size(); ++i) {
      gltf_.Nodes(gltf_.Item("scenes", i), "nodes", Place("scenes", i));
    }
  }

  /// Only what is drawn of a material: its colour.
  void CheckMaterials(std::vector<std::string>* ignored) const {
    int transforms = 0;
    int other_coordinates = 0;
    for (std::size_t i = 0; i < gltf_.Array("materials").size(); ++i) {
      const Json* texture = Member(gltf_.Item("materials", i), "pbrMetallicRoughness");
      if (texture != nullptr) texture = Member(*texture, "baseColorTexture");
      if (texture == nullptr) continue;
      const std::string place = Place("materials", i) + ".baseColorTexture";
      gltf_.Reference(*texture, "index", "textures", place);
      if (gltf_.Count(*texture, "texCoord", place, 0) != 0) ++other_coordinates;
      const Json* extensions = Member(*texture, "extensions");
      if (extensions != nullptr && extensions->contains("KHR_texture_transform")) ++transforms;
    }
    if (transforms > 0) {
      ignored->push_back(std::to_string(transforms) +
                         " transforms of textures (KHR_texture_transform)");
    }
    if (other_coordinates > 0) {
      ignored->push_back(std::to_string(other_coordinates) +
                         " textures' choices of other coordinates (texCoord)");
    }
  }

  /// An object in an object, or null.
  static const Json* Member(const Json& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_object() ? &*found : nullptr;
  }

  /// A node with two parents, or one that is its own ancestor, would be walked without end.
  void CheckNodes() const {
    const std::size_t count = gltf_.Array("nodes").size();
    std::vector<std::size_t> parent(count, count);
    for (std::size_t i = 0; i < count; ++i) {
      const std::string place = Place("nodes", i);
      const Json& node = gltf_.Item("nodes", i);
      gltf_.Reference(node, "mesh", "meshes", place);
      for (const std::size_t child : gltf_.Nodes(node, "children", place)) {
        std::size_t& its_parent = parent[child];
        if (its_parent != count) gltf_.Fail(place, "shares a child with another node");
        its_parent = i;
      }
    }
    CheckDepths(parent);
  }

  /// `parent` of a root is the number of nodes.
  void CheckDepths(const std::vector<std::size_t>& parent) const {
    constexpr auto kUnknown = std::numeric_limits<std::size_t>::max();
    const std::size_t count = parent.size();
    std::vector<std::size_t> depth(count, kUnknown);
    std::vector<std::size_t> path;
    for (std::size_t i = 0; i < count; ++i) {
      path.clear();
      std::size_t at = i;
      for (; at != count && depth[at] == kUnknown; at = parent[at]) {
        if (path.size() > count) gltf_.Fail(Place("nodes", at), "is its own ancestor");
        path.push_back(at);
      }
      std::size_t level = at == count ? 0 : depth[at] + 1;
      for (std::size_t k = path.size(); k-- > 0;) depth[path[k]] = level++;
      if (depth[i] <= kMaxNodeDepth) continue;
      throw FileError(file_, Place("nodes", i), std::string("is ").append(kTooDeep));
    }
  }

  const std::filesystem::path& file_;
  const GltfDocument gltf_;
  std::deque<std::optional<std::vector<std::uint8_t>>> loaded_;  // what buffer_data_ lends
  std::vector<Bytes> buffer_data_;
  std::vector<Bytes> view_data_;
};

}  // namespace

void CheckGltf(const std::filesystem::path& file, std::span<const std::uint8_t> bytes,
               CheckedMeshFile* checked) {
  GltfChecker(file, bytes).Check(checked);
}

}  // namespace bulletnav::sim
