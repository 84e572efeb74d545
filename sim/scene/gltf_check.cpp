// SPDX-License-Identifier: MIT
#include "sim/scene/gltf_check.h"

#include <cstring>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "sim/base/error.h"
#include "sim/base/files.h"

namespace bulletnav::sim {
namespace {

using Json = nlohmann::json;
using Bytes = std::span<const std::uint8_t>;

constexpr std::uint32_t kGlbMagic = 0x46546C67;   // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;  // "JSON"
constexpr std::uint32_t kBinChunk = 0x004E4942;   // "BIN"

std::uint64_t ReadUint(Bytes bytes, std::size_t offset, std::size_t size) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < size; ++i) value |= std::uint64_t{bytes[offset + i]} << (8 * i);
  return value;
}

class GltfChecker {
 public:
  GltfChecker(const std::filesystem::path& file, Bytes bytes) : file_(file), bytes_(bytes) {}

  void Check() {
    ParseChunks();
    if (!json_.is_object()) Fail("", "is not a glTF document");
    for (std::size_t i = 0; i < Array("buffers").size(); ++i) CheckBuffer(i);
    for (std::size_t i = 0; i < Array("bufferViews").size(); ++i) CheckBufferView(i);
    for (std::size_t i = 0; i < Array("accessors").size(); ++i) CheckAccessor(i);
    for (std::size_t i = 0; i < Array("meshes").size(); ++i) CheckMesh(i);
    for (std::size_t i = 0; i < Array("images").size(); ++i) CheckImage(i);
    CheckReferences();
    CheckNodes();
  }

 private:
  [[noreturn]] void Fail(const std::string& place, const std::string& what) const {
    throw FileError(file_, place, what + "; the file is damaged, export or download it again");
  }

  void ParseChunks() {
    Bytes json_bytes = bytes_;
    if (bytes_.size() >= 4 && ReadUint(bytes_, 0, 4) == kGlbMagic) json_bytes = SplitGlb();
    json_ = Json::parse(json_bytes.begin(), json_bytes.end(), nullptr, false);
    if (json_.is_discarded()) Fail("", "holds no readable JSON");
  }

  /// Returns the JSON chunk, keeps the binary one.
  Bytes SplitGlb() {
    if (bytes_.size() < 20) Fail("", "ends inside its header");
    const std::uint64_t length = ReadUint(bytes_, 8, 4);
    if (length > bytes_.size()) {
      Fail("", "is cut off: " + std::to_string(bytes_.size()) + " of " + std::to_string(length) +
                   " bytes are there");
    }
    Bytes json_chunk;
    for (std::size_t at = 12; at + 8 <= length;) {
      const std::uint64_t size = ReadUint(bytes_, at, 4);
      const std::uint64_t type = ReadUint(bytes_, at + 4, 4);
      if (size > length - at - 8) Fail("", "has a chunk that runs past its end");
      const Bytes chunk = bytes_.subspan(at + 8, size);
      if (type == kJsonChunk) json_chunk = chunk;
      if (type == kBinChunk) binary_ = chunk;
      at += 8 + size;
    }
    return json_chunk;
  }

  const Json& Array(const char* name) const {
    static const Json kEmpty = Json::array();
    const auto found = json_.find(name);
    if (found == json_.end()) return kEmpty;
    if (!found->is_array()) Fail(name, "is not a list");
    return *found;
  }

  const Json& Item(const char* name, std::size_t i) const {
    const Json& item = Array(name)[i];
    if (!item.is_object()) Fail(Place(name, i), "is not an object");
    return item;
  }

  static std::string Place(const char* name, std::size_t i) {
    return std::string(name) + "[" + std::to_string(i) + "]";
  }

  /// A member that counts something; `otherwise` where it is absent.
  std::uint64_t Count(const Json& object, const char* key, const std::string& place,
                      std::optional<std::uint64_t> otherwise = std::nullopt) const {
    const auto found = object.find(key);
    if (found == object.end()) {
      if (otherwise) return *otherwise;
      Fail(place, std::string("has no '") + key + "'");
    }
    if (!found->is_number_unsigned()) Fail(place + "." + key, "is not a whole number");
    const auto value = found->get<std::uint64_t>();
    if (value > (std::uint64_t{1} << 40)) Fail(place + "." + key, "is absurdly large");
    return value;
  }

  /// The index that `object[key]` holds into list `list`, if any.
  std::optional<std::size_t> Reference(const Json& object, const char* key, const char* list,
                                       const std::string& place) const {
    if (!object.contains(key)) return std::nullopt;
    const std::uint64_t index = Count(object, key, place);
    if (index >= Array(list).size()) {
      Fail(place + "." + key, "refers to " + Place(list, index) + ", which does not exist");
    }
    return index;
  }

  void CheckBuffer(std::size_t i) {
    const Json& buffer = Item("buffers", i);
    const std::string place = Place("buffers", i);
    const std::uint64_t length = Count(buffer, "byteLength", place);
    const auto uri = buffer.find("uri");
    if (uri == buffer.end()) {
      if (i != 0 || length > binary_.size()) {
        Fail(place, "needs " + std::to_string(length) + " bytes of which the file holds " +
                        std::to_string(i == 0 ? binary_.size() : 0));
      }
      data_[i] = binary_;
    } else if (!uri->is_string()) {
      Fail(place + ".uri", "is not a text");
    } else if (const auto& name = uri->get_ref<const std::string&>(); !name.starts_with("data:")) {
      const std::filesystem::path path = file_.parent_path() / name;
      std::error_code error;
      const std::uintmax_t size = std::filesystem::file_size(path, error);
      if (error) throw FileError(file_, place, "needs '" + name + "', which is not beside it");
      if (size < length) Fail(place, "'" + name + "' is shorter than the document says");
    }
    buffer_lengths_.push_back(length);
  }

  void CheckBufferView(std::size_t i) {
    const Json& view = Item("bufferViews", i);
    const std::string place = Place("bufferViews", i);
    const auto buffer = Reference(view, "buffer", "buffers", place);
    if (!buffer) Fail(place, "has no 'buffer'");
    const std::uint64_t offset = Count(view, "byteOffset", place, 0);
    const std::uint64_t length = Count(view, "byteLength", place);
    if (offset + length > buffer_lengths_[*buffer]) Fail(place, "runs past the end of its buffer");
    const auto data = data_.find(*buffer);
    view_data_.push_back(data == data_.end() ? Bytes() : data->second.subspan(offset, length));
    view_lengths_.push_back(length);
  }

  std::size_t ComponentSize(const Json& accessor, const std::string& place) const {
    switch (Count(accessor, "componentType", place)) {
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
        Fail(place + ".componentType", "is not one of glTF's");
    }
  }

  std::size_t Components(const Json& accessor, const std::string& place) const {
    static const std::map<std::string, std::size_t> kComponents = {
        {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4},
        {"MAT2", 4},   {"MAT3", 9}, {"MAT4", 16}};
    const auto type = accessor.find("type");
    if (type == accessor.end() || !type->is_string()) Fail(place, "has no 'type'");
    const auto found = kComponents.find(type->get<std::string>());
    if (found == kComponents.end()) Fail(place + ".type", "is not one of glTF's");
    return found->second;
  }

  void CheckAccessor(std::size_t i) {
    const Json& accessor = Item("accessors", i);
    const std::string place = Place("accessors", i);
    const std::uint64_t count = Count(accessor, "count", place);
    const std::size_t size = ComponentSize(accessor, place) * Components(accessor, place);
    const auto view = Reference(accessor, "bufferView", "bufferViews", place);
    if (!view || count == 0) return;
    const Json& view_json = Item("bufferViews", *view);
    const std::uint64_t stride = Count(view_json, "byteStride", Place("bufferViews", *view), size);
    if (stride < size) Fail(place, "overlaps itself");
    const std::uint64_t offset = Count(accessor, "byteOffset", place, 0);
    if (offset + stride * (count - 1) + size > view_lengths_[*view]) {
      Fail(place, "runs past the end of its buffer view");
    }
  }

  void CheckMesh(std::size_t i) {
    const Json& mesh = Item("meshes", i);
    const auto primitives = mesh.find("primitives");
    if (primitives == mesh.end() || !primitives->is_array()) {
      Fail(Place("meshes", i), "has no list of primitives");
    }
    for (std::size_t k = 0; k < primitives->size(); ++k) {
      const std::string place = Place("meshes", i) + ".primitives[" + std::to_string(k) + "]";
      const Json& primitive = (*primitives)[k];
      if (!primitive.is_object()) Fail(place, "is not an object");
      CheckPrimitive(primitive, place);
    }
  }

  void CheckPrimitive(const Json& primitive, const std::string& place) {
    Reference(primitive, "material", "materials", place);
    const auto attributes = primitive.find("attributes");
    if (attributes == primitive.end() || !attributes->is_object()) {
      Fail(place, "has no attributes");
    }
    std::optional<std::uint64_t> vertices;
    for (const auto& [name, unused] : attributes->items()) {
      const auto accessor = Reference(*attributes, name.c_str(), "accessors", place);
      const std::uint64_t count = Count(Item("accessors", *accessor), "count", place);
      if (vertices.value_or(count) != count) Fail(place, "has attributes of different lengths");
      vertices = count;
    }
    const auto indices = Reference(primitive, "indices", "accessors", place);
    if (indices) CheckIndices(*indices, vertices.value_or(0), place);
  }

  void CheckIndices(std::size_t i, std::uint64_t vertices, const std::string& place) const {
    const Json& accessor = Item("accessors", i);
    const auto view = Reference(accessor, "bufferView", "bufferViews", place);
    if (!view || view_data_[*view].empty() || accessor.contains("sparse")) return;
    const std::string name = Place("accessors", i);
    const std::size_t size = ComponentSize(accessor, name);
    const std::uint64_t offset = Count(accessor, "byteOffset", name, 0);
    const std::uint64_t stride =
        Count(Item("bufferViews", *view), "byteStride", Place("bufferViews", *view), size);
    const std::uint64_t count = Count(accessor, "count", name);
    for (std::uint64_t k = 0; k < count; ++k) {
      const std::uint64_t index = ReadUint(view_data_[*view], offset + k * stride, size);
      if (index < vertices) continue;
      Fail(place, "index " + std::to_string(k) + " is vertex " + std::to_string(index) + " of " +
                      std::to_string(vertices));
    }
  }

  void CheckImage(std::size_t i) const {
    Reference(Item("images", i), "bufferView", "bufferViews", Place("images", i));
  }

  void CheckReferences() const {
    for (std::size_t i = 0; i < Array("textures").size(); ++i) {
      Reference(Item("textures", i), "source", "images", Place("textures", i));
      Reference(Item("textures", i), "sampler", "samplers", Place("textures", i));
    }
    Reference(json_, "scene", "scenes", "document");
    for (std::size_t i = 0; i < Array("scenes").size(); ++i) {
      CheckList(Item("scenes", i), "nodes", Place("scenes", i));
    }
  }

  /// Every entry of object[key] must be a node.
  void CheckList(const Json& object, const char* key, const std::string& place) const {
    const auto list = object.find(key);
    if (list == object.end()) return;
    if (!list->is_array()) Fail(place + "." + key, "is not a list");
    for (const Json& entry : *list) {
      if (!entry.is_number_unsigned() || entry.get<std::uint64_t>() >= Array("nodes").size()) {
        Fail(place + "." + key, "names a node that does not exist");
      }
    }
  }

  /// A node with two parents, or one that is its own ancestor, would be walked without end.
  void CheckNodes() const {
    const std::size_t count = Array("nodes").size();
    std::vector<std::size_t> parent(count, count);
    for (std::size_t i = 0; i < count; ++i) {
      const std::string place = Place("nodes", i);
      const Json& node = Item("nodes", i);
      Reference(node, "mesh", "meshes", place);
      CheckList(node, "children", place);
      for (const Json& child : node.value("children", Json::array())) {
        std::size_t& its_parent = parent[child.get<std::size_t>()];
        if (its_parent != count) Fail(place, "shares a child with another node");
        its_parent = i;
      }
    }
    for (std::size_t i = 0; i < count; ++i) {
      std::size_t steps = 0;
      for (std::size_t at = i; parent[at] != count; at = parent[at]) {
        if (++steps > count) Fail(Place("nodes", i), "is its own ancestor");
      }
    }
  }

  const std::filesystem::path& file_;
  Bytes bytes_;
  Bytes binary_;
  Json json_;
  std::vector<std::uint64_t> buffer_lengths_;
  std::map<std::size_t, Bytes> data_;
  std::vector<Bytes> view_data_;
  std::vector<std::uint64_t> view_lengths_;
};

}  // namespace

void CheckGltf(const std::filesystem::path& file, std::span<const std::uint8_t> bytes) {
  GltfChecker(file, bytes).Check();
}

}  // namespace bulletnav::sim
