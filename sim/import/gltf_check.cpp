// SPDX-License-Identifier: MIT
#include "sim/import/gltf_check.h"

#include <deque>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/import/gltf_decode.h"
#include "sim/import/gltf_document.h"
#include "sim/import/gltf_objects.h"
#include "sim/import/mesh_file_check.h"
#include "sim/import/meshopt.h"
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
    CheckMaterials();
    TellIgnored(&checked->ignored);
    checked->objects = ReadGltfObjects(gltf_, view_data_);
    DecodedGltf decoded = DecodeGltf(gltf_, view_data_, decompressed_);
    TellPictureless(decoded.json, &checked->ignored);
    if (!decoded.is_changed && !gltf_.counts_in_floats()) return;
    checked->content = gltf_.With(std::move(decoded.json));
    checked->decoded = std::move(decoded.buffer);
  }

 private:
  void CheckBuffer(std::size_t i) {
    const Json& buffer = gltf_.Item("buffers", i);
    const std::string place = Place("buffers", i);
    const std::uint64_t length = gltf_.Count(buffer, "byteLength", place);
    const Bytes data = BufferData(buffer, i, place);
    if (data.empty() && IsFallback(buffer)) {
      buffer_data_.emplace_back();
      return;
    }
    if (length > data.size()) {
      gltf_.Fail(place, "needs " + std::to_string(length) + " bytes of which " + Holder(buffer) +
                            " holds " + std::to_string(data.size()));
    }
    buffer_data_.push_back(data.first(length));
  }

  /// A buffer that is there only in name, for readers that do not know the extension.
  static bool IsFallback(const Json& buffer) {
    return !buffer.contains("uri") && ExtensionOf(buffer, kMeshopt) != nullptr;
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
    if (!path) {
      throw FileError(file_, place,
                      "needs '" + name +
                          "', which is not beside it; put it there, or take the scene as one .glb");
    }
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
    decompressed_.push_back(false);
    if (const Json* packed = ExtensionOf(view, kMeshopt)) {
      const auto& data = loaded_.emplace_back(
          DecodeMeshopt(gltf_, *packed, buffer_data_, place + ".extensions." + kMeshopt));
      view_data_.push_back(*data);
      decompressed_.back() = true;
      return;
    }
    const auto buffer = gltf_.Reference(view, "buffer", "buffers", place);
    if (!buffer) gltf_.Fail(place, "has no 'buffer'");
    const std::uint64_t offset = gltf_.Count(view, "byteOffset", place, 0);
    const std::uint64_t length = gltf_.Count(view, "byteLength", place);
    const Bytes data = buffer_data_[*buffer];
    if (offset + length > data.size()) gltf_.Fail(place, "runs past the end of its buffer");
    view_data_.push_back(data.subspan(offset, length));
  }

  void CheckAccessor(std::size_t i) {
    const Json& accessor = gltf_.Item("accessors", i);
    const std::string place = Place("accessors", i);
    const std::uint64_t count = gltf_.Count(accessor, "count", place);
    const std::size_t size =
        gltf_.ComponentSize(accessor, place) * gltf_.Components(accessor, place);
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
    if (ExtensionOf(primitive, "KHR_draco_mesh_compression") != nullptr) {
      throw FileError(
          file_, place,
          "is compressed by Draco (KHR_draco_mesh_compression), which is not read; open "
          "the file in Blender and export it as glTF 2.0 without compression");
    }
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
    const std::size_t size = gltf_.ComponentSize(accessor, name);
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
  void CheckMaterials() const {
    for (std::size_t i = 0; i < gltf_.Array("materials").size(); ++i) {
      const Json* texture = ColorTextureOf(gltf_.Item("materials", i));
      if (texture == nullptr) continue;
      const std::string place = Place("materials", i) + ".baseColorTexture";
      gltf_.Reference(*texture, "index", "textures", place);
      gltf_.Count(*texture, "texCoord", place, 0);
    }
  }

  /// Textures that are drawn and name no picture, neither their own nor, `decoded`, in a format of
  /// an extension.
  void TellPictureless(const Json& decoded, std::vector<std::string>* ignored) const {
    for (std::size_t i = 0; i < gltf_.Array("materials").size(); ++i) {
      const Json* texture = ColorTextureOf(gltf_.Item("materials", i));
      if (texture == nullptr) continue;
      const auto index = gltf_.Reference(*texture, "index", "textures", Place("materials", i));
      if (!index || decoded["textures"][*index].contains("source")) continue;
      ignored->push_back("texture " + std::to_string(*index) + " of " + Place("materials", i) +
                         ", which names no picture");
    }
  }

  /// What the file cannot be understood without, by its own word, and is read without.
  void TellIgnored(std::vector<std::string>* ignored) const {
    for (const Json& name : gltf_.Array("extensionsRequired")) {
      if (!name.is_string()) gltf_.Fail("extensionsRequired", "holds what is no text");
      const auto& text = name.get_ref<const std::string&>();
      if (IsReadExtension(text)) continue;
      ignored->push_back("extension " + text + ", which the file says it requires");
    }
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
  std::vector<bool> decompressed_;  // by view
};

}  // namespace

void CheckGltf(const std::filesystem::path& file, std::span<const std::uint8_t> bytes,
               CheckedMeshFile* checked) {
  GltfChecker(file, bytes).Check(checked);
}

}  // namespace bulletnav::sim
