// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace bulletnav::sim {

/// The JSON of a .glb or .gltf file and the binary chunk, read with suspicion: what is asked for is
/// of the right kind, or a FileError names its place. Keeps loans of `file` and `bytes`.
class GltfDocument {
 public:
  using Json = nlohmann::json;
  using Bytes = std::span<const std::uint8_t>;

  /// Throws FileError if chunks are cut off, the JSON cannot be read, or it is of
  /// glTF 1.
  GltfDocument(const std::filesystem::path& file, Bytes bytes);

  const Json& json() const { return json_; }
  Bytes binary() const { return binary_; }

  /// Throws FileError, with the remedy for damaged files.
  [[noreturn]] void Fail(const std::string& place, const std::string& what) const;
  /// "name[i]".
  static std::string Place(const std::string& name, std::size_t i);

  /// A list of the document; empty where it is absent.
  const Json& Array(const char* name) const;
  /// An object in it.
  const Json& Item(const char* name, std::size_t i) const;
  /// A member that counts something; `otherwise` where it is absent.
  std::uint64_t Count(const Json& object, const char* key, const std::string& place,
                      std::optional<std::uint64_t> otherwise = std::nullopt) const;
  /// The index that `object[key]` holds into list `list`, if any.
  std::optional<std::size_t> Reference(const Json& object, const char* key, const char* list,
                                       const std::string& place) const;
  /// The indices of nodes that `object[key]` lists.
  std::vector<std::size_t> Nodes(const Json& object, const char* key,
                                 const std::string& place) const;

  /// Bytes of one of an accessor's numbers, and how many of them make an element.
  std::size_t ComponentSize(const Json& accessor, const std::string& place) const;
  std::size_t Components(const Json& accessor, const std::string& place) const;

  /// Whether something that counts was written as 1.0: legal JSON, of which assimp believes that
  /// nothing is there.
  bool counts_in_floats() const { return counts_in_floats_; }
  /// The same file with other JSON, in which 1 stands for 1.0 if counts_in_floats.
  std::vector<std::uint8_t> With(Json json) const;

 private:
  Bytes SplitGlb(Bytes bytes);
  void RefuseVersion1() const;
  std::uint64_t WholeNumber(const Json& value, const std::string& place) const;

  const std::filesystem::path& file_;
  bool is_glb_ = false;
  Bytes binary_;
  Json json_;
  mutable bool counts_in_floats_ = false;
};

/// An object in an object, or null.
const nlohmann::json* MemberOf(const nlohmann::json& object, const char* key);
/// What a material says of the texture that it is drawn with, or null.
const nlohmann::json* ColorTextureOf(const nlohmann::json& material);
/// What an extension says of an object, or null.
const nlohmann::json* ExtensionOf(const nlohmann::json& object, const char* name);

/// A little-endian number of `size` bytes.
std::uint64_t ReadUint(std::span<const std::uint8_t> bytes, std::size_t offset, std::size_t size);

}  // namespace bulletnav::sim
