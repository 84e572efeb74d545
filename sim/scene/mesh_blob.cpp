// SPDX-License-Identifier: MIT
#include "sim/scene/mesh_blob.h"

#include <cstring>
#include <type_traits>

#include "sim/base/error.h"

namespace bulletnav::sim {
namespace {

/// Types whose bytes are their value, alone or in arrays.
template <class T>
inline constexpr bool kIsPlain =
    std::is_trivially_copyable_v<T> || std::is_same_v<T, Eigen::Vector3f> ||
    std::is_same_v<T, Eigen::Vector2f>;
static_assert(sizeof(Eigen::Vector3f) == 12 && sizeof(Eigen::Vector2f) == 8);

class Writer {
 public:
  template <class T>
  void operator()(const T& value) {
    static_assert(kIsPlain<T>);
    Append(&value, sizeof(T));
  }
  void operator()(const std::string& text) { Array(text); }
  template <class T>
  void operator()(const std::vector<T>& items) {
    if constexpr (kIsPlain<T>) {
      Array(items);
    } else {
      (*this)(std::uint64_t{items.size()});
      for (const T& item : items) Fields(item, *this);
    }
  }
  std::vector<std::uint8_t> bytes;

 private:
  template <class Container>
  void Array(const Container& items) {
    (*this)(std::uint64_t{items.size()});
    Append(items.data(), items.size() * sizeof(items[0]));
  }
  void Append(const void* data, std::size_t size) {
    const auto* from = static_cast<const std::uint8_t*>(data);
    bytes.insert(bytes.end(), from, from + size);
  }
};

class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> bytes) : left_(bytes) {}

  template <class T>
  void operator()(T& value) {
    static_assert(kIsPlain<T>);
    Take(&value, sizeof(T));
  }
  void operator()(std::string& text) { Array(text); }
  template <class T>
  void operator()(std::vector<T>& items) {
    if constexpr (kIsPlain<T>) {
      Array(items);
    } else {
      items.resize(Count(1));
      for (T& item : items) Fields(item, *this);
    }
  }

 private:
  template <class Container>
  void Array(Container& items) {
    items.resize(Count(sizeof(items[0])));
    Take(items.data(), items.size() * sizeof(items[0]));
  }
  std::size_t Count(std::size_t item_size) {
    std::uint64_t count = 0;
    (*this)(count);
    if (count > left_.size() / item_size) throw Error("the scene's bytes end early");
    return count;
  }
  void Take(void* to, std::size_t size) {
    if (size > left_.size()) throw Error("the scene's bytes end early");
    if (size > 0) std::memcpy(to, left_.data(), size);
    left_ = left_.subspan(size);
  }
  std::span<const std::uint8_t> left_;
};

// What each struct consists of, once for both directions: S may be const or not.
template <class S, class Archive>
void Fields(S& item, Archive& archive) {
  using T = std::remove_const_t<S>;
  if constexpr (std::is_same_v<T, std::string>) {
    archive(item);
  } else if constexpr (std::is_same_v<T, Texture>) {
    archive(item.name);
    archive(item.image.width);
    archive(item.image.height);
    archive(item.image.channels);
    archive(item.image.pixels);
  } else if constexpr (std::is_same_v<T, Material>) {
    archive(item.name);
    archive(item.base_color);
    archive(item.texture);
  } else if constexpr (std::is_same_v<T, SceneObject>) {
    archive(item.category);
    archive(item.name);
    archive(item.room);
  } else if constexpr (std::is_same_v<T, DoorLeaf>) {
    archive(item.object);
    archive(item.hinge);
    archive(item.axis);
    archive(item.angle);
    archive(item.shut_angle);
    archive(item.open_angle);
    archive(item.leads_outside);
  } else {
    static_assert(std::is_same_v<T, ImportedScene>);
    archive(item.mesh.positions);
    archive(item.mesh.uvs);
    archive(item.mesh.colors);
    archive(item.mesh.triangles);
    archive(item.mesh.triangle_materials);
    archive(item.mesh.materials);
    archive(item.mesh.textures);
    archive(item.mesh.objects);
    archive(item.mesh.triangle_objects);
    archive(item.report.triangles);
    archive(item.report.materials);
    archive(item.report.textures_found);
    archive(item.report.textures_missing);
    archive(item.report.extent_m);
    archive(item.report.up_axis);
    archive(item.report.skipped);
    archive(item.doors);
  }
}

}  // namespace

std::vector<std::uint8_t> ToBlob(const ImportedScene& scene) {
  Writer writer;
  Fields(scene, writer);
  return std::move(writer.bytes);
}

ImportedScene FromBlob(std::span<const std::uint8_t> blob) {
  ImportedScene scene;
  Reader reader(blob);
  Fields(scene, reader);
  return scene;
}

}  // namespace bulletnav::sim
