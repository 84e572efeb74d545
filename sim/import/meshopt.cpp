// SPDX-License-Identifier: MIT
#include "sim/import/meshopt.h"

#include <meshoptimizer.h>

namespace bulletnav::sim {
namespace {

using Json = GltfDocument::Json;
using Bytes = GltfDocument::Bytes;

constexpr std::uint64_t kMostBytes = std::uint64_t{4} << 30;

struct Packed {
  Bytes bytes;
  std::size_t count = 0;
  std::size_t stride = 0;
  std::string mode;
  std::string filter;
};

std::string Text(const Json& object, const char* key, const char* otherwise) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : otherwise;
}

Packed ReadPacked(const GltfDocument& gltf, const Json& json, std::span<const Bytes> buffers,
                  const std::string& place) {
  Packed packed;
  const auto buffer = gltf.Reference(json, "buffer", "buffers", place);
  if (!buffer) gltf.Fail(place, "has no 'buffer'");
  const std::uint64_t offset = gltf.Count(json, "byteOffset", place, 0);
  const std::uint64_t length = gltf.Count(json, "byteLength", place);
  if (offset + length > buffers[*buffer].size()) {
    gltf.Fail(place, "runs past the end of its buffer");
  }
  packed.bytes = buffers[*buffer].subspan(offset, length);
  packed.count = gltf.Count(json, "count", place);
  packed.stride = gltf.Count(json, "byteStride", place);
  packed.mode = Text(json, "mode", "");
  packed.filter = Text(json, "filter", "NONE");
  const bool is_sane = packed.stride >= 1 && packed.stride <= 256;
  if (!is_sane || packed.count > kMostBytes / packed.stride) gltf.Fail(place, "is absurdly large");
  return packed;
}

/// Whether meshoptimizer may be asked: it checks its input, but expects sizes as the format has
/// them.
bool HasSizesOfMode(const Packed& packed) {
  if (packed.mode == "ATTRIBUTES") return packed.stride % 4 == 0;
  const bool is_index = packed.stride == 2 || packed.stride == 4;
  if (packed.mode == "TRIANGLES") return is_index && packed.count % 3 == 0;
  return packed.mode == "INDICES" && is_index;
}

bool Decode(const Packed& packed, std::uint8_t* out) {
  const std::uint8_t* from = packed.bytes.data();
  const std::size_t size = packed.bytes.size();
  if (packed.mode == "ATTRIBUTES") {
    return meshopt_decodeVertexBuffer(out, packed.count, packed.stride, from, size) == 0;
  }
  if (packed.mode == "TRIANGLES") {
    return meshopt_decodeIndexBuffer(out, packed.count, packed.stride, from, size) == 0;
  }
  return meshopt_decodeIndexSequence(out, packed.count, packed.stride, from, size) == 0;
}

/// False for a filter that does not exist or does not fit.
bool Unfilter(const Packed& packed, std::uint8_t* data) {
  if (packed.filter == "NONE") return true;
  if (packed.mode != "ATTRIBUTES") return false;
  if (packed.filter == "OCTAHEDRAL" && (packed.stride == 4 || packed.stride == 8)) {
    meshopt_decodeFilterOct(data, packed.count, packed.stride);
  } else if (packed.filter == "QUATERNION" && packed.stride == 8) {
    meshopt_decodeFilterQuat(data, packed.count, packed.stride);
  } else if (packed.filter == "EXPONENTIAL") {
    meshopt_decodeFilterExp(data, packed.count, packed.stride);
  } else {
    return false;
  }
  return true;
}

}  // namespace

std::vector<std::uint8_t> DecodeMeshopt(const GltfDocument& gltf, const Json& packed_json,
                                        std::span<const Bytes> buffers, const std::string& place) {
  const Packed packed = ReadPacked(gltf, packed_json, buffers, place);
  if (!HasSizesOfMode(packed)) gltf.Fail(place, "has sizes that its mode does not allow");
  std::vector<std::uint8_t> data(packed.count * packed.stride);
  if (!Decode(packed, data.data())) gltf.Fail(place, "cannot be decoded");
  if (!Unfilter(packed, data.data())) gltf.Fail(place, "has an unknown filter");
  return data;
}

}  // namespace bulletnav::sim
