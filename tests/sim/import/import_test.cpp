// SPDX-License-Identifier: MIT
#include "sim/scene/import.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/files.h"
#include "sim/math/rng.h"
#include "sim/scene/glb_writer.h"
#include "tests/support/imports.h"
#include "tests/support/scenes.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::sim {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using tests::ImportError;
using tests::TemporaryFolder;
using Vec = Eigen::Vector3f;

/// A flat square room in OBJ, y up, with walls; faces can be appended.
const std::string kRoomObj =
    "v 0 0 0\nv 4 0 0\nv 4 0 -6\nv 0 0 -6\nv 0 3 0\nv 4 3 0\nv 4 3 -6\nv 0 3 -6\n"
    "f 1 2 3 4\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\nf 5 6 7 8\n";

TEST(Import, GlbComesBackAsItWasWritten) {
  SceneMesh mesh = tests::BoxRoom(4, 2.6f, 6);
  Texture texture{"checks", Image(64, 64, 4)};
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      std::uint8_t* p = texture.image.at(x, y);
      p[0] = p[1] = p[2] = (x / 16 + y / 16) % 2 == 0 ? 230 : 30;
      p[3] = 255;
    }
  }
  mesh.textures.push_back(texture);
  mesh.materials[1].texture = 0;
  mesh.colors[0] = {10, 128, 250};
  const TemporaryFolder folder;
  const auto file = folder.path() / "room.glb";
  WriteFileAtomically(file, EncodeGlb(mesh));
  const ImportedScene scene = ImportScene(file);
  EXPECT_EQ(scene.report.triangles, 12u);
  EXPECT_EQ(scene.report.materials, mesh.materials.size());
  EXPECT_EQ(scene.report.textures_found, 1u);
  EXPECT_TRUE(scene.report.textures_missing.empty());
  EXPECT_TRUE(scene.report.skipped.empty());
  EXPECT_EQ(scene.report.up_axis, UpAxis::kY);
  EXPECT_TRUE(scene.report.extent_m.isApprox(Vec(4, 2.6f, 6)));
  ASSERT_EQ(scene.mesh.positions.size(), mesh.positions.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    EXPECT_EQ(scene.mesh.positions[v], mesh.positions[v]);
    EXPECT_TRUE(scene.mesh.uvs[v].isApprox(mesh.uvs[v], 1e-6f));
    EXPECT_EQ(scene.mesh.colors[v], mesh.colors[v]);
  }
  for (std::size_t m = 0; m < mesh.materials.size(); ++m) {
    EXPECT_EQ(scene.mesh.materials[m].base_color, mesh.materials[m].base_color);
  }
  EXPECT_NEAR(scene.mesh.textures[0].image.at(8, 8)[0], 230, 10);
  EXPECT_NEAR(scene.mesh.textures[0].image.at(24, 8)[0], 30, 10);
}

TEST(Import, ObjWithMaterialsAndTexture) {
  const TemporaryFolder folder;
  Image red(8, 8, 3);
  for (std::size_t i = 0; i < red.pixels.size(); i += 3) red.pixels[i] = 200;
  WritePng(folder.path() / "tex" / "My Wood.png", red);
  folder.Write("room.mtl",
               "newmtl wood\nKd 1 1 1\nmap_Kd textures\\my%20wood.PNG\nnewmtl gone\n"
               "map_Kd nowhere.png\nnewmtl blue\nKd 0 0 0.5\n");
  const auto file =
      folder.Write("room.obj", "mtllib room.mtl\nvt 0 0\nvt 1 0\nvt 1 1\nusemtl wood\n" + kRoomObj +
                                   "usemtl gone\nf 1 3 7\nusemtl blue\nf 1/1 3/2 8/3\n");
  const ImportedScene scene = ImportScene(file);
  EXPECT_EQ(scene.report.triangles, 14u);
  EXPECT_EQ(scene.report.textures_found, 1u);
  EXPECT_THAT(scene.report.textures_missing, ElementsAre(HasSubstr("nowhere.png: file not found")));
  EXPECT_EQ(scene.mesh.textures[0].image.at(0, 0)[0], 200);
  bool has_blue = false;
  for (const Material& m : scene.mesh.materials) has_blue |= m.base_color == Rgb8{0, 0, 128};
  EXPECT_TRUE(has_blue);
}

/// Of the triangles that come last.
std::string LastMaterial(const SceneMesh& mesh) {
  return mesh.materials[mesh.triangle_materials.back()].name;
}

TEST(Import, ObjTellsOfWhatLightGoesThrough) {
  const TemporaryFolder folder;
  for (const auto& [opacity, name] :
       {std::pair{"d 0.3", "pane (see-through)"}, std::pair{"Tr 0.7", "pane (see-through)"},
        std::pair{"d 1", "pane"}, std::pair{"d 0.95", "pane"}, std::pair{"d 0", "pane"}}) {
    folder.Write("room.mtl",
                 std::string("newmtl wood\nKd 1 1 1\nnewmtl pane\nKd 0 0 1\n") + opacity + "\n");
    const auto file = folder.Write(
        "room.obj", "mtllib room.mtl\nusemtl wood\n" + kRoomObj + "usemtl pane\nf 1 3 7\n");
    EXPECT_EQ(LastMaterial(ImportScene(file).mesh), name) << opacity;
  }
}

TEST(Import, ABrokenTextureIsGreyAndNamed) {
  const TemporaryFolder folder;
  folder.Write("bad.png", "this is no picture");
  folder.Write("room.mtl", "newmtl m\nmap_Kd bad.png\n");
  const auto file = folder.Write("room.obj", "mtllib room.mtl\nusemtl m\n" + kRoomObj);
  const ImportedScene scene = ImportScene(file);
  EXPECT_THAT(scene.report.textures_missing, ElementsAre(HasSubstr("bad.png")));
  for (const std::uint32_t m : scene.mesh.triangle_materials) {
    EXPECT_EQ(scene.mesh.materials[m].texture, -1);
    EXPECT_EQ(scene.mesh.materials[m].base_color, (Rgb8{160, 160, 160}));
  }
}

TEST(Import, AMaterialLibraryThatIsMissingIsNamed) {
  const TemporaryFolder folder;
  folder.Write("a b.mtl", "newmtl m\nKd 1 0 0\n");
  const auto file =
      folder.Write("room.obj", "mtllib a b.mtl\r\nmtllib gone.mtl \n# mtllib no.mtl\n" + kRoomObj);
  EXPECT_THAT(ImportScene(file).report.skipped, ElementsAre(HasSubstr("gone.mtl, which is not")));
}

TEST(Import, ObjWithColoursAtItsVerticesAlone) {
  const TemporaryFolder folder;
  std::string obj;
  for (const char* corner :
       {"0 0 0", "4 0 0", "4 0 -6", "0 0 -6", "0 3 0", "4 3 0", "4 3 -6", "0 3 -6"}) {
    obj += std::string("v ") + corner + " 0.8 0.4 0.2\n";
  }
  const auto file = folder.Write("room.obj", obj + kRoomObj.substr(kRoomObj.find("f 1 2 3 4")));
  const SceneMesh mesh = ImportScene(file).mesh;
  EXPECT_THAT(mesh.colors, testing::Each(Rgb8{204, 102, 51}));
  for (const std::uint32_t material : mesh.triangle_materials) {
    EXPECT_EQ(mesh.materials[material].base_color, kWhite);
  }
}

std::string PlyText(const std::string& format, const std::string& body) {
  return "ply\nformat " + format +
         " 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\n"
         "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 6\n"
         "property list uchar int vertex_indices\nend_header\n" +
         body;
}

/// The room lying z up.
const std::string kAsciiPly = PlyText(
    "ascii",
    "0 0 0 255 0 0\n4 0 0 0 255 0\n4 6 0 0 0 255\n0 6 0 9 9 9\n0 0 3 9 9 9\n4 0 3 9 9 9\n"
    "4 6 3 9 9 9\n0 6 3 9 9 9\n4 0 1 2 3\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n4 4 5 6 7\n");

/// The same in binary.
std::string BinaryPly(bool is_big_endian) {
  std::string body;
  const auto add = [&](auto value) {
    std::array<char, sizeof(value)> bytes{};
    std::memcpy(bytes.data(), &value, sizeof(value));
    if (is_big_endian) std::reverse(bytes.begin(), bytes.end());
    body.append(bytes.begin(), bytes.end());
  };
  std::istringstream text(kAsciiPly.substr(kAsciiPly.find("0 0 0 255")));
  for (int i = 0; i < 8 * 6; ++i) {
    float number = 0.0f;
    text >> number;
    i % 6 < 3 ? add(number) : add(static_cast<std::uint8_t>(number));
  }
  for (int i = 0; i < 6 * 5; ++i) {
    std::int32_t number = 0;
    text >> number;
    i % 5 == 0 ? add(static_cast<std::uint8_t>(number)) : add(number);
  }
  return PlyText(is_big_endian ? "binary_big_endian" : "binary_little_endian", body);
}

/// The last byte but `from_end` is another.
std::string Replaced(std::string bytes, std::size_t from_end, char other) {
  bytes[bytes.size() - 1 - from_end] = other;
  return bytes;
}

class PlyTest : public testing::TestWithParam<std::string> {};

TEST_P(PlyTest, WithVertexColoursIsTurnedUpright) {
  const TemporaryFolder folder;
  const ImportedScene scene = ImportScene(folder.Write("room.ply", GetParam()));
  EXPECT_EQ(scene.report.up_axis, UpAxis::kZ);
  EXPECT_TRUE(scene.report.extent_m.isApprox(Vec(4, 3, 6)));
  EXPECT_EQ(scene.report.triangles, 12u);
  bool has_red = false;
  for (const Rgb8& c : scene.mesh.colors) has_red |= c == Rgb8{255, 0, 0};
  EXPECT_TRUE(has_red);
}

INSTANTIATE_TEST_SUITE_P(Import, PlyTest,
                         testing::Values(kAsciiPly, BinaryPly(false), BinaryPly(true)));

const std::string kColladaFloor =
    "<?xml version='1.0'?><COLLADA xmlns='http://www.collada.org/2005/11/COLLADASchema' "
    "version='1.4.1'><asset><unit name='meter' meter='1'/><up_axis>Z_UP</up_axis></asset>"
    "<library_geometries><geometry id='g'><mesh><source id='p'><float_array id='pa' "
    "count='12'>0 0 0 4 0 0 4 6 0 0 6 0</float_array><technique_common><accessor "
    "source='#pa' count='4' stride='3'><param name='X' type='float'/><param name='Y' "
    "type='float'/><param name='Z' type='float'/></accessor></technique_common></source>"
    "<vertices id='v'><input semantic='POSITION' source='#p'/></vertices><triangles count='2'>"
    "<input semantic='VERTEX' source='#v' offset='0'/><p>0 1 2 0 2 3</p></triangles></mesh>"
    "</geometry></library_geometries><library_visual_scenes><visual_scene id='s'><node id='n'>"
    "<instance_geometry url='#g'/></node></visual_scene></library_visual_scenes><scene>"
    "<instance_visual_scene url='#s'/></scene></COLLADA>";

TEST(Import, ColladaFollowsItsOwnUpAxis) {
  const TemporaryFolder folder;
  const auto file = folder.Write("floor.dae", kColladaFloor);
  const ImportedScene scene = ImportScene(file);
  EXPECT_NEAR(scene.report.extent_m.x(), 4.0f, 1e-4f);
  EXPECT_NEAR(scene.report.extent_m.y(), 0.0f, 1e-4f);
  EXPECT_NEAR(scene.report.extent_m.z(), 6.0f, 1e-4f);
}

TEST(Import, UpAndScaleCanBeGiven) {
  const TemporaryFolder folder;
  const auto file = folder.Write("room.obj", kRoomObj);
  ImportOptions options;
  options.up = UpAxis::kZ;
  options.scale = 2.0;
  const ImportedScene scene = ImportScene(file, options);
  EXPECT_TRUE(scene.report.extent_m.isApprox(Vec(8, 12, 6)));
}

TEST(Import, AGroundPlaneCarriesWhatHasNoFloor) {
  const TemporaryFolder folder;
  const auto file = folder.Write("walls.obj", kRoomObj.substr(0, kRoomObj.find("f 1 2 3 4")) +
                                                  "f 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  ImportOptions options;
  options.ground_plane = true;
  options.up = UpAxis::kY;
  const ImportedScene scene = ImportScene(file, options);
  EXPECT_EQ(scene.report.triangles, 10u);
  EXPECT_EQ(scene.mesh.Bounds().min().x(), -1.0f);
  EXPECT_EQ(scene.mesh.Bounds().min().y(), 0.0f);
}

TEST(Import, CleansAndSaysWhatItSkipped) {
  const TemporaryFolder folder;
  std::string obj = kRoomObj + "f 1 1 2\nf 3 2 1\n";  // no area; repeated in another winding
  for (int i = 0; i < 20; ++i) {  // enough good faces around one bad and one stray
    obj += "v 0 0." + std::to_string(i + 10) + " 0\nv 4 0." + std::to_string(i + 10) +
           " 0\nv 4 0." + std::to_string(i + 10) + " -1\nf -1 -2 -3\n";
  }
  obj += "v nan 0 0\nf -1 1 2\n";
  for (int i = 0; i < 100; ++i) obj += "v 1 1." + std::to_string(i + 100) + " -2\nf -1 7 6\n";
  obj += "v 50000 0 0\nv 50001 0 0\nv 50000 1 0\nf -1 -2 -3\n";
  const ImportedScene scene = ImportScene(folder.Write("messy.obj", obj));
  EXPECT_EQ(scene.report.triangles, 12u + 20u + 100u);
  EXPECT_THAT(scene.report.skipped,
              testing::UnorderedElementsAre("1 triangles with NaN or infinite corners",
                                            "1 stray triangles far away",
                                            "1 triangles without area", "1 repeated triangles"));
  EXPECT_LT(scene.report.extent_m.maxCoeff(), 10.0f);
}

struct BadFile {
  const char* name;
  const char* file;
  std::string content;
  const char* error;
};

class BadFileTest : public testing::TestWithParam<BadFile> {};

TEST_P(BadFileTest, IsRefusedInOneLineThatNamesIt) {
  const TemporaryFolder folder;
  const auto file = folder.Write(GetParam().file, GetParam().content);
  const std::string error = ImportError(file);
  EXPECT_THAT(error, HasSubstr(file.string()));
  EXPECT_THAT(error, HasSubstr(GetParam().error));
  EXPECT_THAT(error, testing::Not(HasSubstr("\n")));
}

std::string Glb() {
  const std::vector<std::uint8_t> bytes = EncodeGlb(tests::BoxRoom(4, 3, 6));
  return {bytes.begin(), bytes.end()};
}

TEST(Import, GlbKeepsWhatTrianglesBelongTo) {
  SceneMesh mesh = tests::BoxRoom(4, 2.6f, 6);
  mesh.objects = {{}, {"wall", "wall_1", "bedroom_1"}, {"box \"x\"", "box_1", ""}};
  mesh.triangle_objects.assign(mesh.triangles.size(), 1);
  mesh.triangle_objects[0] = 0;
  tests::AddBox({1, 0, -2}, {2, 1, -1}, {10, 20, 30}, &mesh);
  mesh.triangle_objects.resize(mesh.triangles.size(), 2);
  // Objects may share corners: the file has those twice.
  mesh.triangle_objects.back() = 1;
  mesh.Validate();
  const TemporaryFolder folder;
  const auto file = folder.path() / "room.glb";
  WriteFileAtomically(file, EncodeGlb(mesh));
  ImportOptions options;
  options.ground_plane = true;
  const SceneMesh back = ImportScene(file, options).mesh;
  ASSERT_EQ(back.objects.size(), 4u);
  EXPECT_TRUE(std::equal(mesh.objects.begin(), mesh.objects.end(), back.objects.begin()));
  EXPECT_EQ(back.objects[3].category, "ground_plane");
  ASSERT_EQ(back.triangle_objects.size(), mesh.triangles.size() + 2);
  // Triangles come by material; told by their middles.
  const auto middle = [](const SceneMesh& of, std::size_t t) -> Vec {
    const auto& [a, b, c] = of.triangles[t];
    return (of.positions[a] + of.positions[b] + of.positions[c]) / 3.0f;
  };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::size_t k = 0;
    while (!middle(back, k).isApprox(middle(mesh, t), 1e-6f)) ASSERT_LT(++k, back.triangles.size());
    EXPECT_EQ(back.triangle_objects[k], mesh.triangle_objects[t]) << t;
  }
}

TEST(Import, AFileThatNamesNoObjectsHasNone) {
  const TemporaryFolder folder;
  const SceneMesh mesh = ImportScene(folder.Write("room.glb", Glb())).mesh;
  EXPECT_TRUE(mesh.objects.empty());
  EXPECT_FALSE(mesh.has_objects());
}

/// A .glb with one word of its JSON exchanged for another of the same length.
std::string GlbWith(const std::string& from, const std::string& to) {
  std::string glb = Glb();
  glb.replace(glb.find(from), from.size(), to);
  return glb;
}

using Changes = std::vector<std::pair<std::string, std::string>>;

/// A square floor whose buffer is at `uri`, with some texts exchanged.
std::string FloorGltf(const std::string& uri, const Changes& changes = {}) {
  std::string gltf =
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
      R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)"
      R"("buffers":[{"byteLength":60,"uri":")" +
      uri +
      R"("}],"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":48},)"
      R"({"buffer":0,"byteOffset":48,"byteLength":12}],"accessors":[)"
      R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,-4],"max":[4,0,0]},)"
      R"({"bufferView":1,"componentType":5123,"count":6,"type":"SCALAR"}]})";
  for (const auto& [from, to] : changes) gltf.replace(gltf.find(from), from.size(), to);
  return gltf;
}

/// Its buffer: four corners, two triangles, the last corner chosen.
std::string FloorBuffer(std::uint16_t last_corner) {
  const std::array<float, 12> corners = {0, 0, 0, 4, 0, 0, 4, 0, -4, 0, 0, -4};
  const std::array<std::uint16_t, 6> indices = {0, 1, 2, 0, 2, last_corner};
  std::string bytes(reinterpret_cast<const char*>(corners.data()), sizeof(corners));
  return bytes.append(reinterpret_cast<const char*>(indices.data()), sizeof(indices));
}

/// The same as a data URI.
std::string FloorUri(std::uint16_t last_corner) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::string bytes = FloorBuffer(last_corner);
  std::string uri = "data:application/octet-stream;base64,";
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) bits = bits << 8 | static_cast<std::uint8_t>(bytes[i + k]);
    for (const int shift : {18, 12, 6, 0}) uri += kDigits[bits >> shift & 63];
  }
  return uri;
}

std::string ManyObjFaces(const std::string& vertex) {
  return "v 0 0 0\nv 4 0 0\nv " + vertex + "\nf 1 2 3\n";
}

INSTANTIATE_TEST_SUITE_P(
    All, BadFileTest,
    testing::Values(
        BadFile{"empty", "a.glb", "", "is empty"},
        BadFile{"garbage_glb", "a.glb", "not a glb at all, just text", "is damaged or no glTF"},
        BadFile{"pointer", "a.glb", "version https://git-lfs.github.com/spec/v1", "git lfs pull"},
        BadFile{"page", "a.glb", "<!DOCTYPE html><html></html>", "is a web page"},
        BadFile{"cut_glb", "a.glb", Glb().substr(0, 2000), "is cut off"},
        BadFile{"cut_header", "a.glb", Glb().substr(0, 10), "ends inside its header"},
        BadFile{"glb_buffer", "a.glb", GlbWith("\"buffer\":0", "\"buffer\":3"),
                "refers to buffers[3], which does not exist"},
        BadFile{"glb_material", "a.glb", GlbWith("\"material\":5", "\"material\":9"),
                "refers to materials[9], which does not exist"},
        BadFile{"glb_count", "a.glb", GlbWith("\"count\":4,", "\"count\":7,"), "runs past the end"},
        BadFile{"glb_component", "a.glb", GlbWith("5126", "5127"), "componentType"},
        BadFile{"garbage_obj", "a.obj", std::string(3000, '\x7f'), "a.obj"},
        BadFile{"obj_without_faces", "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", "a.obj"},
        BadFile{"obj_index", "a.obj", "v 0 0 0\nv 4 0 0\nv 4 0 4\nf 1 2 9\n", "a.obj"},
        BadFile{"nan", "a.obj", ManyObjFaces("nan 0 0"), "NaN or infinite"},
        BadFile{"infinite", "a.obj", ManyObjFaces("inf 0 4"), "NaN or infinite"},
        BadFile{"flat", "a.obj", ManyObjFaces("8 0 0"), "holds no triangles"},
        BadFile{"huge", "a.obj", ManyObjFaces("4000 0 4000"), "--scale"},
        BadFile{"tiny", "a.obj", "v 0 0 0\nv 0.01 0 0\nv 0 0 0.01\nf 1 2 3\n", "--scale"},
        BadFile{"far_away", "a.obj", "v 1e8 0 0\nv 1.0000001e8 0 0\nv 1e8 0 80\nf 1 2 3\n",
                "from the origin"},
        BadFile{"ply_cut", "a.ply", kAsciiPly.substr(0, 260), "a.ply"},
        BadFile{"ply_last_line", "a.ply", kAsciiPly.substr(0, kAsciiPly.size() - 3),
                "a.ply:26: holds fewer numbers than it announces"},
        BadFile{"ply_list", "a.ply",
                PlyText("ascii", kAsciiPly.substr(kAsciiPly.find("0 0 0 255"), 113) + "1.5 0 1 2"),
                "has a list without a length"},
        BadFile{"ply_binary_cut", "a.ply", BinaryPly(false).substr(0, BinaryPly(false).size() - 3),
                "a.ply:face 5: has more data than the file holds"},
        BadFile{"ply_binary_list", "a.ply", Replaced(BinaryPly(true), 17 * 5 - 1, '\xff'),
                "a.ply:face 1: has more data"},
        BadFile{"ply_binary_index", "a.ply", Replaced(BinaryPly(false), 0, '\xff'),
                "a.ply:face 5: has vertex 4278190087 of 8"},
        BadFile{"ply_index", "a.ply", kAsciiPly.substr(0, kAsciiPly.size() - 2) + "8\n",
                "a.ply:26: has a face with vertex 8 of 8"},
        BadFile{"millimetres", "a.obj", "v 0 0 0\nv 22000 0 0\nv 22000 0 9000\nf 1 2 3\n",
                "--scale"},
        BadFile{"ply_count", "a.ply", PlyText("binary_little_endian", std::string(20, 'x')),
                "cut off or damaged"},
        BadFile{"ply_header", "a.ply", "ply\nformat ascii 1.0\n", "the header does not end"},
        BadFile{"ply_points", "a.ply",
                "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                "property float z\nend_header\n0 0 0\n",
                "a.ply"},
        BadFile{"unknown_format", "a.xyz", "hello", "is not a .glb, .gltf, .obj, .ply or .dae"},
        BadFile{"gltf_buffer", "a.gltf",
                R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":8,"uri":"gone.bin"}]})",
                "needs 'gone.bin', which is not beside it"},
        BadFile{"gltf_short_data", "a.gltf", FloorGltf(FloorUri(3).substr(0, 77)),
                "buffers[0]: needs 60 bytes of which its data URI holds 30"},
        BadFile{"gltf_bad_data", "a.gltf", FloorGltf("data:;base64,AA*A"), "is not base64"},
        BadFile{"gltf_endless_stride", "a.gltf",
                FloorGltf(FloorUri(3), {{"\"byteOffset\":48,", "\"byteStride\":1099511627776,"},
                                        {"\"count\":6", "\"count\":16777217"}}),
                "accessors[1]: runs past the end of its buffer view"},
        BadFile{"obj_points", "a.obj", "v 0 0 0\nv 4 0 0\nv 4 0 4\np 1 2 3\n",
                "holds no triangles; is it a point cloud? Export"},
        BadFile{"obj_small", "a.obj", "v 0 0 0\n",
                "OBJ-file is too small; export or download it again"},
        BadFile{"gltf_1", "a.gltf", R"({"asset":{"version":"1.0"},"meshes":{}})",
                "asset.version: is '1.0'; export the scene as glTF 2.0"},
        BadFile{"gltf_cycle", "a.gltf",
                R"({"asset":{"version":"2.0"},"nodes":[{"children":[1]},{"children":[0]}]})",
                "is its own ancestor"}),
    [](const auto& bad) {
      return bad.param.name;
    });

TEST(Import, MissingFilesAndFoldersAreSaid) {
  const TemporaryFolder folder;
  EXPECT_THAT(ImportError(folder.path() / "none.glb"), HasSubstr("No such file"));
  EXPECT_THAT(ImportError(folder.path()), HasSubstr("is a directory"));
}

TEST(Import, IndicesOutOfRangeAreFoundInTheBinaryToo) {
  std::string glb = Glb();
  const std::uint32_t three = 3;
  const std::uint32_t many = 1'000'000;
  // The last primitive's indices close the file: 0 1 2 0 2 3.
  ASSERT_EQ(std::memcmp(&glb[glb.size() - 4], &three, 4), 0);
  std::memcpy(&glb[glb.size() - 4], &many, 4);
  const TemporaryFolder folder;
  EXPECT_THAT(ImportError(folder.Write("a.glb", glb)), HasSubstr("is vertex 1000000 of 4"));
}

TEST(Import, GltfBuffersMayLieBesideItOrInIt) {
  const TemporaryFolder folder;
  folder.Write("floor.bin", FloorBuffer(3));
  for (const std::string& uri : {std::string("floor.bin"), FloorUri(3)}) {
    const ImportedScene scene = ImportScene(folder.Write("a.gltf", FloorGltf(uri)));
    EXPECT_EQ(scene.report.triangles, 2u);
    EXPECT_TRUE(scene.report.extent_m.isApprox(Vec(4, 0, 4)));
  }
}

/// The floor with a material called pane.
ImportedScene Glazed(const std::string& material) {
  const TemporaryFolder folder;
  const Changes changes = {
      {"\"indices\":1", "\"indices\":1,\"material\":0"},
      {"\"scene\":0",
       R"("scene":0,"extensionsUsed":["KHR_materials_transmission"],"materials":[{"name":"pane",)" +
           material + "}]"}};
  return ImportScene(folder.Write("a.gltf", FloorGltf(FloorUri(3), changes)));
}

TEST(Import, GltfTellsOfWhatLightGoesThrough) {
  const std::string clear = R"("pbrMetallicRoughness":{"baseColorFactor":[1,1,1,0.25]})";
  const std::string blends = R"("alphaMode":"BLEND",)";
  const std::string transmits =
      R"("extensions":{"KHR_materials_transmission":{"transmissionFactor":1}})";
  EXPECT_EQ(LastMaterial(Glazed(blends + clear).mesh), "pane (see-through)");
  EXPECT_EQ(LastMaterial(Glazed(transmits).mesh), "pane (see-through)");
  EXPECT_EQ(LastMaterial(Glazed(clear).mesh), "pane");  // its alpha does not count
  EXPECT_EQ(LastMaterial(Glazed(R"("alphaMode":"BLEND")").mesh), "pane");
}

/// The floor under a chain of nodes, each the next one's parent.
std::string ChainGltf(int length) {
  std::string nodes = "\"nodes\":[";
  for (int i = 1; i < length; ++i) nodes += "{\"children\":[" + std::to_string(i) + "]},";
  return FloorGltf(FloorUri(3), {{"\"nodes\":[{", nodes + "{"}});
}

TEST(Import, ChainsOfNodesAreReadOrRefusedAtOnce) {
  const TemporaryFolder folder;
  EXPECT_EQ(ImportScene(folder.Write("a.gltf", ChainGltf(257))).report.triangles, 2u);
  EXPECT_THAT(ImportError(folder.Write("a.gltf", ChainGltf(258))),
              HasSubstr("nodes[257]: is nested more than 256 deep; flatten"));
  EXPECT_THAT(ImportError(folder.Write("a.gltf", ChainGltf(20'000))), HasSubstr("256 deep"));
}

/// The floor in one file.
std::string FloorGlb(const Changes& changes) {
  std::string json = FloorGltf("", changes);
  const std::string no_uri = ",\"uri\":\"\"";
  json.erase(json.find(no_uri), no_uri.size());
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::string binary = FloorBuffer(3);
  const auto word = [](std::size_t value) {
    const auto number = static_cast<std::uint32_t>(value);
    return std::string(reinterpret_cast<const char*>(&number), sizeof(number));
  };
  return "glTF" + word(2) + word(28 + json.size() + binary.size()) + word(json.size()) + "JSON" +
         json + word(binary.size()) + std::string("BIN", 4) + binary;
}

/// 48.0 is a number like 48 in JSON; assimp takes it for none.
TEST(Import, WholeNumbersInGltfMayHaveAPoint) {
  const TemporaryFolder folder;
  const std::string uri = FloorUri(3);
  const ImportedScene plain = ImportScene(folder.Write("a.gltf", FloorGltf(uri)));
  const Changes changes = {{"\"byteOffset\":48", "\"byteOffset\":48.0"},
                           {"\"nodes\":[0]", "\"nodes\":[0.0]"},
                           {"\"count\":6", "\"count\":6e0"}};
  const ImportedScene scene = ImportScene(folder.Write("b.gltf", FloorGltf(uri, changes)));
  EXPECT_EQ(scene.mesh.triangles, plain.mesh.triangles);
  EXPECT_EQ(scene.mesh.positions, plain.mesh.positions);
  const ImportedScene packed = ImportScene(folder.Write("c.glb", FloorGlb(changes)));
  EXPECT_EQ(packed.mesh.triangles, plain.mesh.triangles);
  EXPECT_EQ(packed.mesh.positions, plain.mesh.positions);
  EXPECT_THAT(
      ImportError(folder.Write("d.gltf", FloorGltf(uri, {{"\"count\":6", "\"count\":5.5"}}))),
      HasSubstr("accessors[1].count: is not a whole number"));
}

TEST(Import, NamesInGltfMayHavePercentCodes) {
  const TemporaryFolder folder;
  const std::filesystem::path place = folder.path() / "100%25 mine";
  MakeFolder(place);
  WriteFileAtomically(place / "my floor.bin", FloorBuffer(3));
  WriteFileAtomically(place / "a.gltf", FloorGltf("my%20floor.bin"));
  EXPECT_EQ(ImportScene(place / "a.gltf").report.triangles, 2u);
  EXPECT_EQ(ImportScene(place.string() + "//a.gltf").report.triangles, 2u);
  WriteFileAtomically(place / "50%25.bin", FloorBuffer(3));
  WriteFileAtomically(place / "a.gltf", FloorGltf("50%25.bin"));
  EXPECT_EQ(ImportScene(place / "a.gltf").report.triangles, 2u);
}

TEST(Import, IndicesOutOfRangeAreFoundInThemToo) {
  const TemporaryFolder folder;
  folder.Write("floor.bin", FloorBuffer(77));
  for (const std::string& uri : {std::string("floor.bin"), FloorUri(77)}) {
    EXPECT_THAT(ImportError(folder.Write("a.gltf", FloorGltf(uri))),
                HasSubstr("a.gltf:meshes[0].primitives[0]: index 5 is vertex 77 of 4"));
  }
}

/// Whatever the bytes are, an import ends in a scene or in an error of one line.
TEST(Import, RandomDamageEndsInAnError) {
  const std::pair<const char*, std::string> originals[] = {
      {"a.glb", Glb()},         {"a.obj", kRoomObj},
      {"a.ply", kAsciiPly},     {"a.ply", BinaryPly(false)},
      {"a.dae", kColladaFloor}, {"a.gltf", FloorGltf(FloorUri(3))}};
  Rng rng(1, "damage");
  const TemporaryFolder folder;
  for (int i = 0; i < 180; ++i) {
    auto [name, bytes] = originals[i % 6];
    for (int k = 0; k <= rng.Below(5); ++k) {
      const auto at = static_cast<std::size_t>(rng.Below(static_cast<int>(bytes.size())));
      bytes[at] = static_cast<char>(rng.Next());
      if (rng.Chance(0.3)) bytes.erase(at, static_cast<std::size_t>(rng.Below(8)));
      if (rng.Chance(0.3)) bytes.insert(at, std::to_string(rng.Next()));
    }
    const std::string error = ImportError(folder.Write(name, bytes));
    EXPECT_THAT(error, testing::Not(HasSubstr("\n")));
    EXPECT_THAT(error, testing::AnyOf("no error", HasSubstr(folder.path().string())));
  }
}

/// One square metre of floor, `up` its normal's axis in the file.
std::string FloorText(const std::string& extension, UpAxis up) {
  const bool is_ply = extension == ".ply";
  std::string text = is_ply ? "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\n"
                              "property float y\nproperty float z\nelement face 1\n"
                              "property list uchar int vertex_indices\nend_header\n"
                            : "";
  for (const char* xy : {"0 0", "1 0", "1 1", "0 1"}) {
    const std::string x(1, xy[0]);
    const std::string y(1, xy[2]);
    text += (is_ply ? "" : "v ") + (up == UpAxis::kZ ? x + " " + y + " 0" : x + " 0 " + y) + "\n";
  }
  return text + (is_ply ? "4 0 1 2 3\n" : "f 1 2 3 4\n");
}

TEST(Import, BareFloorsLieFlatInAnyFormat) {
  const TemporaryFolder folder;
  for (const char* extension : {".ply", ".obj"}) {
    for (const UpAxis up : {UpAxis::kY, UpAxis::kZ}) {
      const ImportedScene scene =
          ImportScene(folder.Write(std::string("floor") + extension, FloorText(extension, up)));
      EXPECT_EQ(scene.report.up_axis, up) << extension;
      EXPECT_EQ(scene.report.extent_m, Vec(1, 0, 1));
    }
  }
}

/// Walls of a room of 8 x 6 m, 2.5 m high, up the file's `up`, without floor and ceiling.
std::string WallsText(UpAxis up) {
  std::string text;
  for (const char* height : {"0", "2.5"}) {
    for (const char* xy : {"0 0", "8 0", "8 6", "0 6"}) {
      const std::string x(1, xy[0]);
      const std::string y(1, xy[2]);
      text += "v " + (up == UpAxis::kZ ? x + " " + y + " " + height : x + " " + height + " " + y);
      text += "\n";
    }
  }
  return text + "f 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
}

TEST(Import, BareWallsStandInAnyFile) {
  const TemporaryFolder folder;
  for (const UpAxis up : {UpAxis::kY, UpAxis::kZ}) {
    const ImportedScene scene = ImportScene(folder.Write("walls.obj", WallsText(up)));
    EXPECT_EQ(scene.report.up_axis, up);
    EXPECT_FLOAT_EQ(scene.report.extent_m.y(), 2.5f);
  }
}

class SharedSceneTest : public testing::TestWithParam<const char*> {};

TEST_P(SharedSceneTest, RealScenesLoad) {
  const auto file = tests::SharedScene(GetParam());
  if (!file) GTEST_SKIP() << "no shared scene " << GetParam();
  const ImportedScene scene = ImportScene(*file);
  EXPECT_EQ(scene.report.up_axis, UpAxis::kZ);
  EXPECT_GT(scene.report.triangles, 10'000u);
  EXPECT_LT(scene.report.extent_m.y(), 4.0f);
  EXPECT_GT(scene.report.extent_m.x(), 10.0f);
}

INSTANTIATE_TEST_SUITE_P(All, SharedSceneTest,
                         testing::Values("aws_small_house", "turtlebot3_house"),
                         [](const auto& name) {
                           return name.param;
                         });

}  // namespace
}  // namespace bulletnav::sim
