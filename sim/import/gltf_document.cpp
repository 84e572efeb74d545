// SPDX-License-Identifier: MIT
#include "sim/import/gltf_document.h"

#include <cmath>
#include <map>
#include <span>
#include <string>
#include <string_view>

#include "sim/base/error.h"

namespace bulletnav::sim {
namespace {

constexpr std::uint32_t kGlbMagic = 0x46546C67;   // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;  // "JSON"
constexpr std::uint32_t kBinChunk = 0x004E4942;   // "BIN"

/// Writes whole numbers as such; minus zero is none.
void MakeIntegers(nlohmann::json* value) {
  if (value->is_structured()) {
    for (auto& entry : *value) MakeIntegers(&entry);
  } else if (value->is_number_float()) {
    const auto number = value->get<double>();
    const bool fits = std::abs(number) <= 1e15 && number == std::floor(number);
    if (fits && !(number == 0.0 && std::signbit(number))) {
      *value = static_cast<std::int64_t>(number);
    }
  }
}

void AppendUint32(std::uint64_t value, std::vector<std::uint8_t>* bytes) {
  for (int i = 0; i < 4; ++i) bytes->push_back(static_cast<std::uint8_t>(value >> (8 * i)));
}

void AppendChunk(std::uint32_t type, std::span<const std::uint8_t> data,
                 std::vector<std::uint8_t>* glb) {
  AppendUint32(data.size(), glb);
  AppendUint32(type, glb);
  glb->insert(glb->end(), data.begin(), data.end());
}

constexpr const char* kNoCount = "is not a whole number from 0 on";

/// What else is often saved under the name of a mesh, and what to do then.
std::string CauseOfNoJson(std::span<const std::uint8_t> bytes) {
  constexpr std::string_view kPointer = "version https://git-lfs";
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (text.starts_with(kPointer)) return "it is a pointer of Git LFS: `git lfs pull` gets the file";
  if (text.starts_with("<")) return "it is a web page: download the file itself";
  return "it is damaged or no glTF; get or export it again";
}

}  // namespace

std::uint64_t ReadUint(std::span<const std::uint8_t> bytes, std::size_t offset, std::size_t size) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < size; ++i) value |= std::uint64_t{bytes[offset + i]} << (8 * i);
  return value;
}

GltfDocument::GltfDocument(const std::filesystem::path& file, Bytes bytes) : file_(file) {
  Bytes json_bytes = bytes;
  is_glb_ = bytes.size() >= 4 && ReadUint(bytes, 0, 4) == kGlbMagic;
  if (is_glb_) json_bytes = SplitGlb(bytes);
  json_ = Json::parse(json_bytes.begin(), json_bytes.end(), nullptr, false);
  if (json_.is_discarded()) {
    throw FileError(file_, "", "holds no readable JSON; " + CauseOfNoJson(bytes));
  }
  if (!json_.is_object()) Fail("", "is not a glTF document");
  RefuseVersion1();
}

/// Version 1 has objects where version 2 has lists.
void GltfDocument::RefuseVersion1() const {
  const auto asset = json_.find("asset");
  if (asset == json_.end() || !asset->is_object()) return;
  const auto version = asset->find("version");
  if (version == asset->end() || !version->is_string()) return;
  const auto& text = version->get_ref<const std::string&>();
  if (!text.starts_with("1.")) return;
  throw FileError(file_, "asset.version", "is '" + text + "'; export the scene as glTF 2.0");
}

void GltfDocument::Fail(const std::string& place, const std::string& what) const {
  throw FileError(file_, place, what + "; the file is damaged, export or download it again");
}

/// Returns the JSON chunk, keeps the binary one.
GltfDocument::Bytes GltfDocument::SplitGlb(Bytes bytes) {
  if (bytes.size() < 20) Fail("", "ends inside its header");
  const std::uint64_t length = ReadUint(bytes, 8, 4);
  if (length > bytes.size()) {
    Fail("", "is cut off: " + std::to_string(bytes.size()) + " of " + std::to_string(length) +
                 " bytes are there");
  }
  Bytes json_chunk;
  for (std::size_t at = 12; at + 8 <= length;) {
    const std::uint64_t size = ReadUint(bytes, at, 4);
    const std::uint64_t type = ReadUint(bytes, at + 4, 4);
    if (size > length - at - 8) Fail("", "has a chunk that runs past its end");
    const Bytes chunk = bytes.subspan(at + 8, size);
    if (type == kJsonChunk) json_chunk = chunk;
    if (type == kBinChunk) binary_ = chunk;
    at += 8 + size;
  }
  return json_chunk;
}

std::string GltfDocument::Place(const std::string& name, std::size_t i) {
  return name + "[" + std::to_string(i) + "]";
}

std::vector<std::uint8_t> GltfDocument::With(Json json) const {
  if (counts_in_floats_) MakeIntegers(&json);
  std::string text = json.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const Bytes text_bytes(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
  if (!is_glb_) return {text_bytes.begin(), text_bytes.end()};
  constexpr std::size_t kHeaders = 12 + 2 * 8;
  std::vector<std::uint8_t> glb;
  AppendUint32(kGlbMagic, &glb);
  AppendUint32(2, &glb);
  AppendUint32(kHeaders + text.size() + binary_.size(), &glb);
  AppendChunk(kJsonChunk, text_bytes, &glb);
  AppendChunk(kBinChunk, binary_, &glb);
  return glb;
}

const GltfDocument::Json& GltfDocument::Array(const char* name) const {
  static const Json empty = Json::array();
  const auto found = json_.find(name);
  if (found == json_.end()) return empty;
  if (!found->is_array()) Fail(name, "is not a list");
  return *found;
}

const GltfDocument::Json& GltfDocument::Item(const char* name, std::size_t i) const {
  const Json& item = Array(name)[i];
  if (!item.is_object()) Fail(Place(name, i), "is not an object");
  return item;
}

std::uint64_t GltfDocument::WholeNumber(const Json& value, const std::string& place) const {
  constexpr std::uint64_t kMost = std::uint64_t{1} << 40;
  if (value.is_number_float()) {
    const auto number = value.get<double>();
    if (!(number >= 0.0) || number != std::floor(number)) Fail(place, kNoCount);
    if (number > static_cast<double>(kMost)) Fail(place, "is absurdly large");
    counts_in_floats_ = true;
    return static_cast<std::uint64_t>(number);
  }
  if (!value.is_number_unsigned()) Fail(place, kNoCount);
  const auto number = value.get<std::uint64_t>();
  if (number > kMost) Fail(place, "is absurdly large");
  return number;
}

std::uint64_t GltfDocument::Count(const Json& object, const char* key, const std::string& place,
                                  std::optional<std::uint64_t> otherwise) const {
  const auto found = object.find(key);
  if (found != object.end()) return WholeNumber(*found, place + "." + key);
  if (!otherwise) Fail(place, std::string("has no '") + key + "'");
  return *otherwise;
}

std::optional<std::size_t> GltfDocument::Reference(const Json& object, const char* key,
                                                   const char* list,
                                                   const std::string& place) const {
  if (!object.contains(key)) return std::nullopt;
  const std::uint64_t index = Count(object, key, place);
  if (index >= Array(list).size()) {
    Fail(place + "." + key, "refers to " + Place(list, index) + ", which does not exist");
  }
  return index;
}

std::vector<std::size_t> GltfDocument::Nodes(const Json& object, const char* key,
                                             const std::string& place) const {
  std::vector<std::size_t> nodes;
  const auto list = object.find(key);
  if (list == object.end()) return nodes;
  if (!list->is_array()) Fail(place + "." + key, "is not a list");
  const std::size_t count = Array("nodes").size();
  nodes.reserve(list->size());
  for (const Json& entry : *list) {
    const std::uint64_t node = WholeNumber(entry, place + "." + key);
    if (node >= count) Fail(place + "." + key, "names a node that does not exist");
    nodes.push_back(node);
  }
  return nodes;
}

std::size_t GltfDocument::ComponentSize(const Json& accessor, const std::string& place) const {
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

std::size_t GltfDocument::Components(const Json& accessor, const std::string& place) const {
  static const std::map<std::string, std::size_t> components = {
      {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}, {"MAT4", 16}};
  const auto type = accessor.find("type");
  if (type == accessor.end() || !type->is_string()) Fail(place, "has no 'type'");
  const auto found = components.find(type->get<std::string>());
  if (found == components.end()) Fail(place + ".type", "is not one of glTF's");
  return found->second;
}

const nlohmann::json* MemberOf(const nlohmann::json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_object() ? &*found : nullptr;
}

const nlohmann::json* ColorTextureOf(const nlohmann::json& material) {
  const nlohmann::json* surface = MemberOf(material, "pbrMetallicRoughness");
  return surface == nullptr ? nullptr : MemberOf(*surface, "baseColorTexture");
}

const nlohmann::json* ExtensionOf(const nlohmann::json& object, const char* name) {
  const nlohmann::json* extensions = MemberOf(object, "extensions");
  return extensions == nullptr ? nullptr : MemberOf(*extensions, name);
}

}  // namespace bulletnav::sim
