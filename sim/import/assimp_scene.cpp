// SPDX-License-Identifier: MIT
#include "sim/import/assimp_scene.h"

#include <cmath>
#include <map>
#include <new>
#include <optional>
#include <span>
#include <string_view>

#include <assimp/GltfMaterial.h>
#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include "sim/base/elementary.h"
#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/image/decode.h"
#include "sim/import/cpu_time.h"
#include "sim/import/mesh_file_check.h"
#include "sim/import/mesh_io.h"
#include "sim/import/texture_files.h"
#include "sim/scene/glass.h"

namespace bulletnav::sim {
namespace {

constexpr const char* kNoTriangles =
    "holds no triangles; is it a point cloud? Export the scene's surfaces as a mesh";
constexpr std::size_t kMaxTriangles = 100'000'000;
constexpr double kClearest = 0.9;    // glass that lets all light through is seen all the same
constexpr int kSecondsAPicture = 9;  // one of 16,384 x 16,384 pixels may be a small file

std::uint8_t ToByte(float value) {
  return static_cast<std::uint8_t>(std::lround(255.0f * std::min(std::max(value, 0.0f), 1.0f)));
}

/// glTF's factors and vertex colours are linear light, the older formats' are display values.
std::uint8_t EncodeSrgb(float linear) {
  const float x = std::min(std::max(linear, 0.0f), 1.0f);
  return ToByte(x <= 0.0031308f ? 12.92f * x : 1.055f * Pow(x, 1.0f / 2.4f) - 0.055f);
}

/// Converts one assimp scene; materials first, then the meshes node by node.
class Converter {
 public:
  Converter(const aiScene& scene, const std::filesystem::path& file, ImportReport* report)
      : scene_(scene), file_(file), report_(*report), is_linear_(IsGltfFile(file)) {}

  SceneMesh Convert() {
    for (unsigned i = 0; i < scene_.mNumMaterials; ++i) AddMaterial(*scene_.mMaterials[i]);
    if (mesh_.materials.empty()) mesh_.materials.push_back({"default", kWhite, -1});
    WhitenDefaults();
    AddNode(*scene_.mRootNode, aiMatrix4x4(), 0);
    if (other_primitives_ > 0) {
      report_.skipped.push_back(std::to_string(other_primitives_) + " points or lines");
    }
    return std::move(mesh_);
  }

 private:
  Rgb8 ToRgb(const aiColor4D& color) const {
    if (is_linear_) return {EncodeSrgb(color.r), EncodeSrgb(color.g), EncodeSrgb(color.b)};
    return {ToByte(color.r), ToByte(color.g), ToByte(color.b)};
  }

  void AddMaterial(const aiMaterial& source) {
    Material material;
    material.name = source.GetName().C_Str();
    aiColor4D color(1.0f, 1.0f, 1.0f, 1.0f);
    if (source.Get(AI_MATKEY_BASE_COLOR, color) != AI_SUCCESS) {
      source.Get(AI_MATKEY_COLOR_DIFFUSE, color);
    }
    material.base_color = ToRgb(color);
    for (const aiTextureType type : {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE}) {
      aiString name;
      if (source.GetTexture(type, 0, &name) != AI_SUCCESS || name.length == 0) continue;
      material.texture = AddTexture(name.C_Str());
      // A black factor under a picture is an exporter's habit, not a wish.
      if (material.base_color == Rgb8{0, 0, 0}) material.base_color = kWhite;
      break;
    }
    if (IsSeeThrough(OpacityOf(source, color.a))) MarkSeeThrough(&material);
    mesh_.materials.push_back(material);
  }

  /// Where a file names no material, assimp's is grey: a factor of what vertices say is none.
  void WhitenDefaults() {
    for (unsigned i = 0; i < scene_.mNumMeshes; ++i) {
      const aiMesh& mesh = *scene_.mMeshes[i];
      if (!mesh.HasVertexColors(0) || mesh.mMaterialIndex >= scene_.mNumMaterials) continue;
      Material& material = mesh_.materials[mesh.mMaterialIndex];
      if (material.name == AI_DEFAULT_MATERIAL_NAME) material.base_color = kWhite;
    }
  }

  /// Of its whole surface; what pictures say of single places is not asked. `alpha`: its colour's.
  double OpacityOf(const aiMaterial& source, float alpha) const {
    float opacity = 1.0f;
    if (!is_linear_) {
      source.Get(AI_MATKEY_OPACITY, opacity);
      return opacity;
    }
    float transmission = 0.0f;
    source.Get(AI_MATKEY_TRANSMISSION_FACTOR, transmission);
    if (transmission > 0.0f) return 1.0 - kClearest * transmission;
    aiString mode;
    const bool blends = source.Get(AI_MATKEY_GLTF_ALPHAMODE, mode) == AI_SUCCESS &&
                        std::string_view(mode.C_Str()) == "BLEND";
    return blends ? alpha : 1.0;
  }

  int AddTexture(const std::string& name) {
    const auto next = static_cast<int>(mesh_.textures.size());
    const auto [place, is_new] = texture_of_name_.try_emplace(name, next);
    if (is_new) mesh_.textures.push_back({name, {}});
    return place->second;
  }

  void AddNode(const aiNode& node, const aiMatrix4x4& parent, int depth) {
    if (depth > kMaxNodeDepth) {
      throw FileError(file_, std::string("node '") + node.mName.C_Str() + "'",
                      std::string("is ").append(kTooDeep));
    }
    const aiMatrix4x4 transform = parent * node.mTransformation;
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
      if (node.mMeshes[i] < scene_.mNumMeshes) AddMesh(*scene_.mMeshes[node.mMeshes[i]], transform);
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i) {
      AddNode(*node.mChildren[i], transform, depth + 1);
    }
  }

  void AddMesh(const aiMesh& source, const aiMatrix4x4& transform) {
    const auto base = static_cast<std::uint32_t>(mesh_.positions.size());
    if (mesh_.triangles.size() + source.mNumFaces > kMaxTriangles) {
      throw FileError(file_, "", "has more than 100 million triangles; cut it up");
    }
    AddVertices(source, transform);
    const std::uint32_t material = std::min<std::uint32_t>(
        source.mMaterialIndex, static_cast<std::uint32_t>(mesh_.materials.size()) - 1);
    for (unsigned f = 0; f < source.mNumFaces; ++f) {
      const aiFace& face = source.mFaces[f];
      if (face.mNumIndices != 3) {
        ++other_primitives_;
        continue;
      }
      for (unsigned k = 0; k < 3; ++k) {
        if (face.mIndices[k] < source.mNumVertices) continue;
        throw FileError(file_, std::string("mesh '") + source.mName.C_Str() + "'",
                        "triangle " + std::to_string(f) + " uses vertex " +
                            std::to_string(face.mIndices[k]) + " of " +
                            std::to_string(source.mNumVertices) + "; export the mesh again");
      }
      mesh_.triangles.push_back(
          {base + face.mIndices[0], base + face.mIndices[1], base + face.mIndices[2]});
      mesh_.triangle_materials.push_back(material);
    }
  }

  void AddVertices(const aiMesh& source, const aiMatrix4x4& transform) {
    for (unsigned i = 0; i < source.mNumVertices; ++i) {
      const aiVector3D p = transform * source.mVertices[i];
      mesh_.positions.emplace_back(p.x, p.y, p.z);
      const bool has_uv = source.HasTextureCoords(0);
      const aiVector3D uv = has_uv ? source.mTextureCoords[0][i] : aiVector3D();
      mesh_.uvs.emplace_back(uv.x, 1.0f - uv.y);
      const bool has_color = source.HasVertexColors(0);
      mesh_.colors.push_back(has_color ? ToRgb(source.mColors[0][i]) : kWhite);
    }
  }

  const aiScene& scene_;
  const std::filesystem::path& file_;
  ImportReport& report_;
  const bool is_linear_;
  SceneMesh mesh_;
  std::map<std::string, int> texture_of_name_;
  std::size_t other_primitives_ = 0;
};

/// Where the same textures are in a format that is read.
std::string BasisRemedy(const std::filesystem::path& mesh) {
  constexpr std::string_view kBasis = ".basis";
  std::string stem = mesh.stem().string();
  if (!stem.ends_with(kBasis)) {
    return "convert the mesh: gltf-transform ktxdecompress " + mesh.filename().string() + " " +
           stem + ".png.glb";
  }
  stem.resize(stem.size() - kBasis.size());
  const std::string plain = stem + ".glb";
  std::error_code ignored;
  if (std::filesystem::exists(mesh.parent_path() / plain, ignored)) {
    return "take " + plain + ", which lies beside it";
  }
  return "take " + plain + ", which HM3D's archives called hm3d-...-glb hold";
}

/// Throws ImageError for a format that is not read, with the remedy for the mesh.
void RequireRead(std::string_view unread, const std::filesystem::path& mesh) {
  if (unread.empty()) return;
  const bool is_ktx = unread == kKtx;
  throw ImageError(
      "is in " + std::string(unread) + ", which is not read; " +
      (is_ktx ? BasisRemedy(mesh) : "export the mesh again with textures in PNG or JPEG"));
}

Image DecodeTexture(std::span<const std::uint8_t> bytes, const std::filesystem::path& mesh) {
  RequireRead(UnreadFormat(bytes), mesh);
  return DecodeImage(bytes);
}

Image DecodeEmbedded(const aiTexture& texture, const std::filesystem::path& mesh) {
  if (texture.mHeight == 0) {
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(texture.pcData);
    return DecodeTexture(std::span(bytes, texture.mWidth), mesh);
  }
  const std::size_t pixels = static_cast<std::size_t>(texture.mWidth) * texture.mHeight;
  if (pixels > kMostKeptPixels) throw ImageError("has more than 8192 x 8192 pixels");
  Image image(static_cast<int>(texture.mWidth), static_cast<int>(texture.mHeight), 4);
  for (std::size_t i = 0; i < pixels; ++i) {
    const aiTexel& t = texture.pcData[i];
    const std::array<std::uint8_t, 4> rgba = {t.r, t.g, t.b, t.a};
    std::copy(rgba.begin(), rgba.end(), &image.pixels[4 * i]);
  }
  return image;
}

/// assimp's reason, with a remedy.
std::string WhyNoScene(std::string reason) {
  if (reason.find("No meshes remaining") != std::string::npos) return kNoTriangles;
  while (reason.ends_with('.') || reason.ends_with('\n')) reason.pop_back();
  return "cannot be read as a mesh: " + reason +
         "; export or download it again, best as glTF 2.0 (.glb)";
}

}  // namespace

AssimpScene::AssimpScene(const std::filesystem::path& file, const CheckedMeshFile& checked,
                         bool keeps_axes)
    : file_(file), importer_(std::make_unique<Assimp::Importer>()) {
  importer_->SetIOHandler(
      new MeshIo(file, checked));  // NOLINT(cppcoreguidelines-owning-memory): it takes it
  importer_->SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                                aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  importer_->SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, keeps_axes);
  try {
    scene_ = importer_->ReadFile(file.string(), aiProcess_Triangulate | aiProcess_SortByPType);
  } catch (const std::bad_alloc&) {
    throw FileError(file, "", "asks for more memory than there is; the file is damaged");
  } catch (const std::exception& e) {
    throw FileError(file, "", std::string("is damaged: ") + e.what());
  }
  if (scene_ == nullptr) {
    throw FileError(file, "", WhyNoScene(importer_->GetErrorString()));
  }
  if (scene_->mRootNode == nullptr || scene_->mNumMeshes == 0) {
    throw FileError(file, "", kNoTriangles);
  }
}

AssimpScene::~AssimpScene() = default;

SceneMesh AssimpScene::Convert(ImportReport* report) const {
  return Converter(*scene_, file_, report).Convert();
}

Image AssimpScene::LoadTexture(const std::string& name) const {
  AllowCpuSeconds(kSecondsAPicture);
  if (const aiTexture* embedded = scene_->GetEmbeddedTexture(name.c_str())) {
    return DecodeEmbedded(*embedded, file_);
  }
  const auto path = FindTextureFile(file_, name);
  if (!path) {
    RequireRead(UnreadFormat(std::filesystem::path(name)), file_);
    throw ImageError("file not found");
  }
  AllowCpuSeconds(SecondsToRead(*path));
  return DecodeTexture(ReadFile(*path), file_);
}

}  // namespace bulletnav::sim
