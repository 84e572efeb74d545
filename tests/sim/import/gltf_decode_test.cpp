// SPDX-License-Identifier: MIT
#include "sim/import/gltf_decode.h"

#include <array>
#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <meshoptimizer.h>
#include <webp/encode.h>

#include "sim/base/error.h"
#include "sim/scene/import.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::sim {
namespace {

using Json = nlohmann::json;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using tests::TemporaryFolder;

using Corner = std::array<float, 4>;  // three numbers, and room for a fourth
constexpr std::array<Corner, 4> kCorners = {Corner{0, 0, 0}, Corner{4, 0, 0}, Corner{4, 0, -4},
                                            Corner{0, 0, -4}};
constexpr std::array<std::uint32_t, 6> kIndices = {0, 1, 2, 0, 2, 3};

/// A glTF document that is put together piece by piece.
class Document {
 public:
  Document() {
    json = {{"asset", {{"version", "2.0"}}},
            {"scene", 0},
            {"scenes", {{{"nodes", {0}}}}},
            {"nodes", {{{"mesh", 0}}}},
            {"meshes", {{{"primitives", {{{"attributes", Json::object()}}}}}}},
            {"buffers", {{{"byteLength", 0}}}},
            {"bufferViews", Json::array()},
            {"accessors", Json::array()}};
  }

  /// A view of bytes; returns its number.
  std::size_t View(const void* data, std::size_t size) {
    binary.resize((binary.size() + 3) / 4 * 4);
    json["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", size}});
    binary.append(static_cast<const char*>(data), size);
    return json["bufferViews"].size() - 1;
  }

  /// A view that is compressed, of something `stride` bytes wide, and lies in a buffer that only
  /// has a length.
  std::size_t PackedView(const std::vector<unsigned char>& packed, std::size_t count,
                         std::size_t stride, const char* mode) {
    View(packed.data(), packed.size());
    Json& view = json["bufferViews"].back();
    Json extension = view;
    extension.update({{"count", count}, {"byteStride", stride}, {"mode", mode}});
    view = {{"buffer", 1}, {"byteOffset", 0}, {"byteLength", count * stride}};
    view["extensions"]["EXT_meshopt_compression"] = extension;
    if (json["buffers"].size() == 1) {
      json["buffers"].push_back({{"byteLength", 100'000}});
      json["buffers"][1]["extensions"]["EXT_meshopt_compression"]["fallback"] = true;
    }
    return json["bufferViews"].size() - 1;
  }

  std::size_t Accessor(std::size_t view, int component, std::size_t count, const char* type) {
    json["accessors"].push_back(
        {{"bufferView", view}, {"componentType", component}, {"count", count}, {"type", type}});
    return json["accessors"].size() - 1;
  }

  void AddFloatPositions() {
    std::vector<float> numbers;
    for (const Corner& c : kCorners) numbers.insert(numbers.end(), c.begin(), c.begin() + 3);
    attributes()["POSITION"] = Accessor(View(numbers.data(), 48), 5126, 4, "VEC3");
  }
  void AddIndices() {
    primitive()["indices"] = Accessor(View(kIndices.data(), 24), 5125, 6, "SCALAR");
  }
  /// A material whose colour is a picture of these bytes, by an extension or none.
  void AddPicture(const std::string& bytes, const char* mime, const char* extension) {
    const std::size_t view = View(bytes.data(), bytes.size());
    json["images"] = {{{"bufferView", view}, {"mimeType", mime}, {"name", "wood"}}};
    json["textures"] = {Json::object()};
    if (extension == nullptr) {
      json["textures"][0]["source"] = 0;
    } else {
      json["textures"][0]["extensions"][extension]["source"] = 0;
      json["extensionsRequired"] = {extension};
    }
    json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
    primitive()["material"] = 0;
  }

  Json& primitive() { return json["meshes"][0]["primitives"][0]; }
  Json& attributes() { return primitive()["attributes"]; }

  std::string Glb() {
    json["buffers"][0]["byteLength"] = binary.size();
    std::string text = json.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::string data = binary;
    data.resize((data.size() + 3) / 4 * 4);
    const auto word = [](std::size_t value) {
      const auto number = static_cast<std::uint32_t>(value);
      return std::string(reinterpret_cast<const char*>(&number), sizeof(number));
    };
    return "glTF" + word(2) + word(28 + text.size() + data.size()) + word(text.size()) + "JSON" +
           text + word(data.size()) + std::string("BIN", 4) + data;
  }

  Json json;
  std::string binary;
};

Document PlainFloor() {
  Document floor;
  floor.AddFloatPositions();
  floor.AddIndices();
  return floor;
}

class GltfDecodeTest : public testing::Test {
 protected:
  ImportedScene Import(Document document, const char* name = "a.glb") {
    return ImportScene(folder_.Write(name, document.Glb()));
  }
  std::string ErrorOf(Document document) {
    try {
      Import(std::move(document));
    } catch (const Error& e) {
      return e.what();
    }
    return "no error";
  }

  TemporaryFolder folder_;
};

TEST_F(GltfDecodeTest, QuantisedPositionsAndCoordinatesBecomeFloats) {
  Document floor;
  std::vector<std::int16_t> positions;
  std::vector<std::uint8_t> uvs;
  for (const Corner& c : kCorners) {
    // Padded to a multiple of four bytes, as the extension asks.
    for (std::size_t i = 0; i < 4; ++i) {
      positions.push_back(static_cast<std::int16_t>(c[i] / 4 * 32767));
    }
    for (const float t : {c[0] / 4, -c[2] / 4, 0.0f, 0.0f}) {
      uvs.push_back(static_cast<std::uint8_t>(t * 255));
    }
  }
  const std::size_t position_view = floor.View(positions.data(), 2 * positions.size());
  floor.json["bufferViews"][position_view]["byteStride"] = 8;
  floor.attributes()["POSITION"] = floor.Accessor(position_view, 5122, 4, "VEC3");
  floor.json["accessors"].back()["normalized"] = true;
  const std::size_t uv_view = floor.View(uvs.data(), uvs.size());
  floor.json["bufferViews"][uv_view]["byteStride"] = 4;
  floor.attributes()["TEXCOORD_0"] = floor.Accessor(uv_view, 5121, 4, "VEC2");
  floor.json["accessors"].back()["normalized"] = true;
  const std::array<std::int8_t, 16> normals = {0, 127, 0, 0, 0, 127, 0, 0,
                                               0, 127, 0, 0, 0, 127, 0, 0};
  floor.attributes()["NORMAL"] =
      floor.Accessor(floor.View(normals.data(), normals.size()), 5120, 4, "VEC3");
  floor.AddIndices();
  floor.json["nodes"][0]["scale"] = {4, 4, 4};
  floor.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  const ImportedScene scene = Import(floor);
  EXPECT_THAT(scene.report.skipped, IsEmpty());
  ASSERT_EQ(scene.mesh.positions.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    const Corner& c = kCorners[i];
    EXPECT_TRUE(scene.mesh.positions[i].isApprox(Eigen::Vector3f(c[0], c[1], c[2]), 1e-4f)) << i;
    EXPECT_NEAR(scene.mesh.uvs[i].x(), c[0] / 4, 1e-5f);
    EXPECT_NEAR(scene.mesh.uvs[i].y(), -c[2] / 4, 1e-5f);
  }
}

/// The floor with everything compressed.
Document PackedFloor() {
  Document floor;
  std::vector<unsigned char> vertices(meshopt_encodeVertexBufferBound(4, sizeof(Corner)));
  vertices.resize(meshopt_encodeVertexBuffer(vertices.data(), vertices.size(), kCorners.data(), 4,
                                             sizeof(Corner)));
  std::vector<unsigned char> indices(meshopt_encodeIndexBufferBound(6, 4));
  indices.resize(meshopt_encodeIndexBuffer(indices.data(), indices.size(), kIndices.data(), 6));
  const std::size_t view = floor.PackedView(vertices, 4, sizeof(Corner), "ATTRIBUTES");
  floor.json["bufferViews"][view]["byteStride"] = sizeof(Corner);
  floor.attributes()["POSITION"] = floor.Accessor(view, 5126, 4, "VEC3");
  floor.primitive()["indices"] =
      floor.Accessor(floor.PackedView(indices, 6, 4, "TRIANGLES"), 5125, 6, "SCALAR");
  floor.json["extensionsRequired"] = {"EXT_meshopt_compression"};
  return floor;
}

TEST_F(GltfDecodeTest, MeshoptimizersCompressionIsUndone) {
  const ImportedScene plain = Import(PlainFloor());
  const ImportedScene scene = Import(PackedFloor());
  EXPECT_EQ(scene.mesh.positions, plain.mesh.positions);
  ASSERT_EQ(scene.mesh.triangles.size(), 2u);
  EXPECT_THAT(scene.report.skipped, IsEmpty());
}

TEST_F(GltfDecodeTest, DamagedCompressionIsNamedByItsPlace) {
  Document floor = PackedFloor();
  floor.binary[1] = '\x7f';
  for (std::size_t i = 2; i < 12; ++i) floor.binary[i] = '\xff';
  Document short_one = PackedFloor();
  short_one.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"]["byteLength"] = 7;
  EXPECT_THAT(ErrorOf(short_one),
              HasSubstr("bufferViews[0].extensions.EXT_meshopt_compression: cannot be decoded"));
  Document wide = PackedFloor();
  wide.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"]["byteStride"] = 257;
  EXPECT_THAT(ErrorOf(wide), HasSubstr("is absurdly large"));
  Document odd = PackedFloor();
  odd.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"]["byteStride"] = 15;
  EXPECT_THAT(ErrorOf(odd), HasSubstr("has sizes that its mode does not allow"));
  // Whatever the bytes are, reading ends in a scene or a sentence.
  EXPECT_NE(ErrorOf(floor), "");
}

TEST_F(GltfDecodeTest, DracosCompressionIsRefusedByName) {
  Document floor = PlainFloor();
  floor.primitive()["extensions"]["KHR_draco_mesh_compression"] = {
      {"bufferView", 0}, {"attributes", {{"POSITION", 0}}}};
  EXPECT_THAT(ErrorOf(floor), HasSubstr("meshes[0].primitives[0]: is compressed by Draco "
                                        "(KHR_draco_mesh_compression), which is not read; open"));
}

TEST_F(GltfDecodeTest, ATexturesOwnCoordinatesAreTakenAndTransformed) {
  Document floor = PlainFloor();
  const std::array<float, 8> zeros = {};
  const std::array<float, 8> ones = {0, 0, 1, 0, 1, 1, 0, 1};
  floor.attributes()["TEXCOORD_0"] = floor.Accessor(floor.View(&zeros, 32), 5126, 4, "VEC2");
  floor.attributes()["TEXCOORD_1"] = floor.Accessor(floor.View(&ones, 32), 5126, 4, "VEC2");
  floor.AddPicture("no picture", "image/png", nullptr);
  Json& texture = floor.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"];
  texture["texCoord"] = 1;
  const ImportedScene chosen = Import(floor);
  EXPECT_THAT(chosen.report.skipped, IsEmpty());
  EXPECT_TRUE(chosen.mesh.uvs[2].isApprox(Eigen::Vector2f(1, 1), 1e-6f));
  // A quarter turn counter-clockwise, as seen with v down: right becomes up.
  texture["extensions"]["KHR_texture_transform"] = {
      {"scale", {2, 3}}, {"offset", {0.25, 0.5}}, {"rotation", 1.5707963267948966}};
  const ImportedScene turned = Import(floor);
  EXPECT_THAT(turned.report.skipped, IsEmpty());
  EXPECT_TRUE(turned.mesh.uvs[0].isApprox(Eigen::Vector2f(0.25f, 0.5f), 1e-5f));
  EXPECT_TRUE(turned.mesh.uvs[1].isApprox(Eigen::Vector2f(0.25f, 0.5f - 2), 1e-5f));
  EXPECT_TRUE(turned.mesh.uvs[3].isApprox(Eigen::Vector2f(0.25f + 3, 0.5f), 1e-5f));
}

TEST_F(GltfDecodeTest, WebpTexturesAreRead) {
  const std::array<std::uint8_t, 12> red = {200, 10, 20, 200, 10, 20, 200, 10, 20, 200, 10, 20};
  std::uint8_t* bytes = nullptr;
  const std::size_t size = WebPEncodeLosslessRGB(red.data(), 2, 2, 6, &bytes);
  const std::string webp(reinterpret_cast<const char*>(bytes), size);
  WebPFree(bytes);
  Document floor = PlainFloor();
  floor.AddPicture(webp, "image/webp", "EXT_texture_webp");
  const ImportedScene scene = Import(floor);
  EXPECT_THAT(scene.report.textures_missing, IsEmpty());
  ASSERT_EQ(scene.mesh.textures.size(), 1u);
  EXPECT_EQ(scene.mesh.textures[0].image.at(0, 0)[0], 200);
}

TEST_F(GltfDecodeTest, BasisTexturesAreGreyAndNamedWithTheRemedy) {
  Document floor = PlainFloor();
  floor.AddPicture("\xabKTX 20\xbb\r\n\x1a\n and so on", "image/ktx2", "KHR_texture_basisu");
  const ImportedScene scene = Import(floor);
  EXPECT_EQ(scene.report.textures_found, 0u);
  EXPECT_THAT(scene.report.textures_missing,
              ElementsAre(HasSubstr("is in Basis Universal (KTX2), which is not read; convert the "
                                    "mesh: gltf-transform ktxdecompress a.glb a.png.glb")));
  EXPECT_EQ(scene.mesh.materials[0].base_color, (Rgb8{160, 160, 160}));
  EXPECT_THAT(Import(floor, "room.basis.glb").report.textures_missing,
              ElementsAre(HasSubstr("take room.glb, which HM3D's archives")));
  folder_.Write("room.glb", PlainFloor().Glb());
  EXPECT_THAT(Import(floor, "room.basis.glb").report.textures_missing,
              ElementsAre(HasSubstr("take room.glb, which lies beside it")));
}

TEST_F(GltfDecodeTest, OtherFormatsOfTexturesAreNamedToo) {
  const std::string avif = std::string("\0\0\0\x1c", 4) + "ftypavif and so on";
  struct Case {
    const char* extension;
    std::string bytes;
    const char* name;
  };
  for (const auto& [extension, bytes, name] :
       {Case{"GOOGLE_texture_basis", "sB and so on", "Basis Universal (.basis)"},
        Case{"MSFT_texture_dds", "DDS and so on", "DDS"}, Case{"EXT_texture_avif", avif, "AVIF"}}) {
    Document floor = PlainFloor();
    floor.AddPicture(bytes, "image/unknown", extension);
    for (const bool is_required : {true, false}) {
      if (!is_required) floor.json.erase("extensionsRequired");
      const ImportedScene scene = Import(floor);
      EXPECT_THAT(scene.report.textures_missing,
                  ElementsAre(HasSubstr("is in " + std::string(name) +
                                        ", which is not read; export the mesh again with")));
      EXPECT_THAT(scene.report.skipped, IsEmpty());
    }
  }
}

TEST_F(GltfDecodeTest, OfAFileThatIsNotThereItsFormatIsToldAsWell) {
  Document floor = PlainFloor();
  floor.AddPicture("", "image/ktx2", "KHR_texture_basisu");
  floor.json["images"] = {{{"uri", "wood.ktx2"}}};
  EXPECT_THAT(Import(floor).report.textures_missing,
              ElementsAre(AllOf(HasSubstr("wood.ktx2"), HasSubstr("ktxdecompress"))));
  floor.json["images"] = {{{"uri", "wood.webp"}}};
  EXPECT_THAT(Import(floor).report.textures_missing,
              ElementsAre(AllOf(HasSubstr("wood.webp"), HasSubstr("not found"))));
}

TEST_F(GltfDecodeTest, ATextureThatNamesNoPictureIsTold) {
  Document floor = PlainFloor();
  floor.AddPicture("", "image/png", nullptr);
  floor.json["textures"][0].erase("source");
  floor.json["images"].clear();
  EXPECT_THAT(Import(floor).report.skipped,
              ElementsAre("texture 0 of materials[0], which names no picture"));
}

TEST_F(GltfDecodeTest, WhatAFileRequiresAndIsNotReadIsNamed) {
  Document floor = PlainFloor();
  floor.json["extensionsRequired"] = {"EXT_mesh_gpu_instancing", "KHR_materials_unlit"};
  EXPECT_THAT(Import(floor).report.skipped,
              ElementsAre("extension EXT_mesh_gpu_instancing, which the file says it requires"));
}

}  // namespace
}  // namespace bulletnav::sim
