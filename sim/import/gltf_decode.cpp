// SPDX-License-Identifier: MIT
#include "sim/import/gltf_decode.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "sim/base/elementary.h"
#include "sim/base/error.h"
#include "sim/import/mesh_file_check.h"
#include "sim/import/meshopt.h"

namespace bulletnav::sim {
namespace {

using Json = GltfDocument::Json;
using Bytes = GltfDocument::Bytes;

constexpr int kFloat = 5126;
constexpr const char* kTransform = "KHR_texture_transform";

/// Extensions by which textures name a picture in another format. WebP is read; of the others each
/// picture is named when it is to be read.
constexpr std::array<const char*, 5> kPictureFormats = {"EXT_texture_webp", "KHR_texture_basisu",
                                                        "GOOGLE_texture_basis", "EXT_texture_avif",
                                                        "MSFT_texture_dds"};

/// (u, v) -> linear (u, v) + offset.
struct UvTransform {
  std::array<float, 4> linear = {1.0f, 0.0f, 0.0f, 1.0f};  // row by row
  std::array<float, 2> offset = {0.0f, 0.0f};
  // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 takes what is compared with for a pointer
  auto operator<=>(const UvTransform&) const = default;
};

/// Which coordinates a material's colour takes, and how.
struct UvChoice {
  std::uint64_t set = 0;
  UvTransform transform;
  auto operator<=>(const UvChoice&) const = default;
};

std::array<double, 2> Pair(const Json& object, const char* key, double otherwise) {
  const auto found = object.find(key);
  std::array<double, 2> pair = {otherwise, otherwise};
  if (found == object.end() || !found->is_array() || found->size() != 2) return pair;
  for (std::size_t i = 0; i < 2; ++i) {
    if ((*found)[i].is_number()) pair[i] = (*found)[i].get<double>();
  }
  return pair;
}

/// Counter-clockwise as seen in the picture, whose v points down.
UvTransform TransformOf(const Json& json) {
  const auto scale = Pair(json, "scale", 1.0);
  const auto offset = Pair(json, "offset", 0.0);
  const auto rotation = json.find("rotation");
  const bool turns = rotation != json.end() && rotation->is_number();
  const double angle = turns ? rotation->get<double>() : 0.0;
  const double c = Cos(angle);
  const double s = Sin(angle);
  UvTransform transform;
  transform.linear = {static_cast<float>(c * scale[0]), static_cast<float>(s * scale[1]),
                      static_cast<float>(-s * scale[0]), static_cast<float>(c * scale[1])};
  transform.offset = {static_cast<float>(offset[0]), static_cast<float>(offset[1])};
  return transform;
}

/// A number of an accessor as a float: integers as they are, or as parts of the greatest.
class NumberReader {
 public:
  NumberReader(std::uint64_t type, bool normalized) : type_(type), normalized_(normalized) {}

  float At(Bytes bytes, std::size_t offset) const {
    const std::uint64_t raw = ReadUint(bytes, offset, Size());
    switch (type_) {
      case 5120:
        return Scaled(static_cast<std::int8_t>(raw), 127.0f);
      case 5121:
        return Scaled(static_cast<float>(raw), 255.0f);
      case 5122:
        return Scaled(static_cast<std::int16_t>(raw), 32767.0f);
      case 5123:
        return Scaled(static_cast<float>(raw), 65535.0f);
      case 5125:
        return static_cast<float>(raw);
      default:
        break;
    }
    const auto bits = static_cast<std::uint32_t>(raw);
    float value = 0.0f;
    std::memcpy(&value, &bits, sizeof(value));
    return value;
  }

 private:
  std::size_t Size() const { return type_ < 5122 ? 1 : type_ < 5124 ? 2 : 4; }
  float Scaled(float value, float greatest) const {
    return normalized_ ? std::max(value / greatest, -1.0f) : value;
  }

  std::uint64_t type_;
  bool normalized_;
};

class Decoder {
 public:
  Decoder(const GltfDocument& gltf, std::span<const Bytes> views)
      : gltf_(gltf), views_(views), buffer_(gltf.Array("buffers").size()) {
    result_.json = gltf.json();
  }

  DecodedGltf Decode(const std::vector<bool>& decompressed) {
    for (std::size_t i = 0; i < decompressed.size(); ++i) {
      if (decompressed[i]) MoveView(i);
    }
    for (std::size_t i = 0; i < gltf_.Array("textures").size(); ++i) ChoosePicture(i);
    for (std::size_t m = 0; m < gltf_.Array("materials").size(); ++m) ReadChoice(m);
    for (std::size_t i = 0; i < gltf_.Array("meshes").size(); ++i) {
      for (Json& primitive : json("meshes")[i]["primitives"]) DecodePrimitive(i, &primitive);
    }
    if (result_.buffer.empty()) return std::move(result_);
    json("buffers").push_back({{"uri", kDecodedBuffer}, {"byteLength", result_.buffer.size()}});
    return std::move(result_);
  }

 private:
  Json& json(const char* list) {
    Json& found = result_.json[list];
    if (found.is_null()) found = Json::array();
    return found;
  }

  /// Appends bytes to the buffer; returns where they begin.
  std::size_t Append(Bytes bytes) {
    result_.is_changed = true;
    result_.buffer.resize((result_.buffer.size() + 3) / 4 * 4);
    const std::size_t offset = result_.buffer.size();
    result_.buffer.insert(result_.buffer.end(), bytes.begin(), bytes.end());
    return offset;
  }

  void MoveView(std::size_t i) {
    Json& view = json("bufferViews")[i];
    const std::size_t offset = Append(views_[i]);
    view["buffer"] = buffer_;
    view["byteOffset"] = offset;
    view["byteLength"] = views_[i].size();
    view.erase("extensions");
  }

  /// What a texture shows is its own picture, or one in a format that an extension names.
  void ChoosePicture(std::size_t i) {
    const Json& texture = gltf_.Item("textures", i);
    const std::string place = GltfDocument::Place("textures", i);
    for (const char* name : kPictureFormats) {
      const Json* extension = ExtensionOf(texture, name);
      if (extension == nullptr || texture.contains("source")) continue;
      const auto source = gltf_.Reference(*extension, "source", "images", place);
      if (!source) continue;
      json("textures")[i]["source"] = *source;
      result_.is_changed = true;
      return;
    }
  }

  void ReadChoice(std::size_t material) {
    UvChoice& choice = choices_[material];
    const std::string place = GltfDocument::Place("materials", material);
    const Json* texture = ColorTextureOf(gltf_.Item("materials", material));
    if (texture == nullptr) return;
    choice.set = gltf_.Count(*texture, "texCoord", place, 0);
    const Json* transform = ExtensionOf(*texture, kTransform);
    if (transform == nullptr) return;
    choice.set = gltf_.Count(*transform, "texCoord", place, choice.set);
    choice.transform = TransformOf(*transform);
  }

  void DecodePrimitive(std::size_t mesh, Json* primitive) {
    const std::string place = GltfDocument::Place("meshes", mesh);
    const auto material = gltf_.Reference(*primitive, "material", "materials", place);
    const UvChoice choice = material ? choices_[*material] : UvChoice();
    Json& attributes = (*primitive)["attributes"];
    const Json before = attributes;
    if (before.contains("POSITION")) Replace("POSITION", 3, {}, &attributes);
    for (const auto& [name, unused] : before.items()) {
      // Light is not drawn, and assimp would take integers for floats.
      if ((name == "NORMAL" || name == "TANGENT") && !IsFloat(before, name))
        Erase(name, &attributes);
    }
    const std::string wanted = "TEXCOORD_" + std::to_string(choice.set);
    if (!before.contains(wanted)) return;
    if (choice.set != 0) attributes["TEXCOORD_0"] = before[wanted];
    result_.is_changed = result_.is_changed || choice.set != 0;
    Replace("TEXCOORD_0", 2, choice.transform, &attributes);
    for (const auto& [name, unused] : before.items()) {
      if (name.starts_with("TEXCOORD_") && name != "TEXCOORD_0" && !IsFloat(before, name)) {
        Erase(name, &attributes);
      }
    }
    if (result_.is_changed) primitive->erase("targets");  // shapes that nobody asks for
  }

  void Erase(const std::string& name, Json* attributes) {
    attributes->erase(name);
    result_.is_changed = true;
  }

  bool IsFloat(const Json& attributes, const std::string& name) const {
    const std::size_t i = attributes[name].get<std::size_t>();
    return gltf_.Count(gltf_.Item("accessors", i), "componentType", "") == kFloat;
  }

  /// Puts an accessor of floats into an attribute's place, if it needs one.
  void Replace(const char* name, std::size_t components, const UvTransform& transform,
               Json* attributes) {
    const auto accessor = (*attributes)[name].get<std::size_t>();
    if (IsFloat(*attributes, name) && transform == UvTransform()) return;
    const auto [place, is_new] = replaced_.try_emplace({accessor, transform}, 0);
    if (is_new) place->second = MakeFloats(accessor, components, transform);
    (*attributes)[name] = place->second;
  }

  std::size_t MakeFloats(std::size_t accessor, std::size_t components,
                         const UvTransform& transform) {
    const std::string place = GltfDocument::Place("accessors", accessor);
    const Json& from = gltf_.Item("accessors", accessor);
    if (gltf_.Components(from, place) != components) {
      gltf_.Fail(place, "has another type than what it is used for");
    }
    std::vector<float> values = ReadFloats(from, components, place);
    for (std::size_t i = 0; components == 2 && i < values.size(); i += 2) {
      const float u = values[i];
      const float v = values[i + 1];
      const auto& m = transform.linear;
      values[i] = m[0] * u + m[1] * v + transform.offset[0];
      values[i + 1] = m[2] * u + m[3] * v + transform.offset[1];
    }
    return AddAccessor(values, components);
  }

  std::vector<float> ReadFloats(const Json& accessor, std::size_t components,
                                const std::string& place) const {
    if (accessor.contains("sparse")) {
      gltf_.Fail(place, "is sparse and not what assimp reads; 'gltf-transform dequantize' helps");
    }
    const std::uint64_t count = gltf_.Count(accessor, "count", place);
    std::vector<float> values(count * components, 0.0f);
    const auto view = gltf_.Reference(accessor, "bufferView", "bufferViews", place);
    if (!view) return values;
    const std::size_t size = gltf_.ComponentSize(accessor, place);
    const std::uint64_t offset = gltf_.Count(accessor, "byteOffset", place, 0);
    const std::uint64_t stride =
        gltf_.Count(gltf_.Item("bufferViews", *view), "byteStride", place, size * components);
    const auto normalized = accessor.find("normalized");
    const NumberReader reader(gltf_.Count(accessor, "componentType", place),
                              normalized != accessor.end() && *normalized == true);
    for (std::uint64_t i = 0; i < values.size(); ++i) {
      const std::uint64_t at = offset + i / components * stride + i % components * size;
      values[i] = reader.At(views_[*view], at);
    }
    return values;
  }

  std::size_t AddAccessor(const std::vector<float>& values, std::size_t components) {
    const Bytes bytes(reinterpret_cast<const std::uint8_t*>(values.data()),
                      values.size() * sizeof(float));
    const std::size_t offset = Append(bytes);
    const std::size_t view = json("bufferViews").size();
    json("bufferViews")
        .push_back({{"buffer", buffer_}, {"byteOffset", offset}, {"byteLength", bytes.size()}});
    json("accessors")
        .push_back({{"bufferView", view},
                    {"componentType", kFloat},
                    {"count", values.size() / components},
                    {"type", components == 2 ? "VEC2" : "VEC3"}});
    return json("accessors").size() - 1;
  }

  const GltfDocument& gltf_;
  std::span<const Bytes> views_;
  std::size_t buffer_;  // its number
  DecodedGltf result_;
  std::map<std::size_t, UvChoice> choices_;  // by material
  std::map<std::pair<std::size_t, UvTransform>, std::size_t> replaced_;
};

}  // namespace

DecodedGltf DecodeGltf(const GltfDocument& gltf, std::span<const Bytes> views,
                       const std::vector<bool>& decompressed) {
  return Decoder(gltf, views).Decode(decompressed);
}

bool IsReadExtension(std::string_view name) {
  constexpr std::array<std::string_view, 4> kRead = {kMeshopt, kTransform, "KHR_mesh_quantization",
                                                     "KHR_lights_punctual"};
  const auto is_in = [name](const auto& names) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  return name.starts_with("KHR_materials_") || is_in(kRead) || is_in(kPictureFormats);
}

}  // namespace bulletnav::sim
