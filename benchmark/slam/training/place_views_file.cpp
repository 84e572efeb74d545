// SPDX-License-Identifier: MIT
#include "benchmark/slam/training/place_views_file.h"

#include <array>
#include <bit>
#include <cstring>
#include <memory>
#include <utility>

#include <fmt/core.h>

#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/math/rng.h"
#include "sim/scene/import.h"
#include "sim/threads/worker_pool.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

static_assert(std::endian::native == std::endian::little);

constexpr std::array<char, 8> kMagic = {'B', 'N', 'P', 'L', 'A', 'C', 'E', 'S'};
constexpr std::uint32_t kVersion = 1;
/// Counts up when the same scene and config come to give other views.
constexpr std::uint64_t kViewsVersion = 2;

struct Header {
  std::array<char, 8> magic = kMagic;
  std::uint32_t version = kVersion;
  std::int32_t places = 0;
  std::int32_t views = 0;
  std::int32_t rows = 0;
  std::int32_t cols = 0;
  std::uint32_t unused = 0;
  std::uint64_t key = 0;
  std::uint64_t checksum = 0;  // of what follows
};
static_assert(sizeof(Header) == 48);

using PoseRow = std::array<double, 4>;

/// Bytes after the header.
std::size_t BodySize(const Header& header) {
  const auto count =
      static_cast<std::size_t>(header.places) * static_cast<std::size_t>(header.views);
  const auto picture =
      static_cast<std::size_t>(header.rows) * static_cast<std::size_t>(header.cols) * 3;
  return count * sizeof(PoseRow) + count * count + count * picture;
}

/// Why bytes are no views of this key; empty if they are.
std::string ProblemOf(std::span<const std::uint8_t> bytes, std::uint64_t key) {
  Header header;
  if (bytes.size() < sizeof(header)) return "ends early";
  std::memcpy(&header, bytes.data(), sizeof(header));
  if (header.magic != kMagic) return "is no file of views of places";
  if (header.version != kVersion) return "is of another version of the program";
  if (header.key != key) return "was made from another scene or config";
  constexpr std::int32_t kMost = 1 << 12;
  for (const std::int32_t size : {header.places, header.views, header.rows, header.cols}) {
    if (size < 1 || size > kMost) return "has a size that cannot be";
  }
  const auto body = bytes.subspan(sizeof(header));
  if (body.size() != BodySize(header)) return "has not the size that it should have";
  if (sim::Hash64(body) != header.checksum) return "is damaged: its checksum does not fit";
  return {};
}

PlaceViews MakeViews(const fs::path& scene, const PlaceDataConfig& config) {
  const auto world =
      sim::World::Load(scene, {config.import.options(), config.navmesh, sim::Backend::kEmbree});
  std::unique_ptr<const sim::RenderScene> changed;
  if (config.looks) {
    const sim::Finish look = DrawLook(*config.looks, config.seed, scene.filename().string());
    if (look != sim::Finish{}) {
      sim::ImportedScene imported = sim::ImportScene(scene, config.import.options());
      sim::SceneMesh mesh = std::move(imported.drawn ? *imported.drawn : imported.mesh);
      sim::ApplyFinish(look, &mesh);
      sim::ApplyDamage(look.damage, &mesh);
      changed = sim::MakeRenderScene(mesh, sim::Backend::kEmbree);
    }
  }
  return MakePlaceViews(*world, changed.get(), config);
}

}  // namespace

void WritePlaceViews(const fs::path& file, const PlaceViews& views, std::uint64_t key) {
  Header header;
  header.places = views.places;
  header.views = views.views;
  header.rows = views.rows;
  header.cols = views.cols;
  header.key = key;
  std::vector<std::uint8_t> bytes(sizeof(Header));
  for (const sim::BodyPose& pose : views.poses) {
    const PoseRow row = {pose.position.x(), pose.position.y(), pose.position.z(), pose.yaw};
    const auto* from = reinterpret_cast<const std::uint8_t*>(row.data());
    bytes.insert(bytes.end(), from, from + sizeof(row));
  }
  bytes.insert(bytes.end(), views.shared.begin(), views.shared.end());
  bytes.insert(bytes.end(), views.pictures.begin(), views.pictures.end());
  header.checksum = sim::Hash64(std::span<const std::uint8_t>(bytes).subspan(sizeof(Header)));
  std::memcpy(bytes.data(), &header, sizeof(header));
  sim::WriteFileAtomically(file, bytes);
}

PlaceViews ReadPlaceViews(const fs::path& file, std::uint64_t key) {
  const std::vector<std::uint8_t> bytes = sim::ReadFile(file);
  if (const std::string problem = ProblemOf(bytes, key); !problem.empty()) {
    throw sim::FileError(file, "", problem);
  }
  Header header;
  std::memcpy(&header, bytes.data(), sizeof(header));
  PlaceViews views;
  views.places = header.places;
  views.views = header.views;
  views.rows = header.rows;
  views.cols = header.cols;
  const auto count = static_cast<std::size_t>(views.count());
  const std::uint8_t* at = bytes.data() + sizeof(header);
  for (std::size_t i = 0; i < count; ++i, at += sizeof(PoseRow)) {
    PoseRow row{};
    std::memcpy(row.data(), at, sizeof(row));
    views.poses.push_back({Eigen::Vector3d(row[0], row[1], row[2]), row[3]});
  }
  views.shared.assign(at, at + count * count);
  views.pictures.assign(at + count * count, bytes.data() + bytes.size());
  return views;
}

PlaceViews PlaceViewsOf(const fs::path& scene, const PlaceDataConfig& config) {
  const std::uint64_t content = sim::Hash64(sim::ReadFile(scene));
  const std::uint64_t name = sim::Hash64(scene.filename().string());  // random numbers depend on it
  const std::uint64_t key =
      sim::MixSeed(sim::MixSeed(content, name), sim::MixSeed(ViewsKey(config), kViewsVersion));
  const fs::path file =
      fs::path(config.cache) / fmt::format("{}-{:016x}.places", scene.stem().string(), key);
  if (fs::exists(file)) {
    try {
      return ReadPlaceViews(file, key);
    } catch (const sim::FileError& e) {
      fmt::print(stderr, "{}; made anew\n", e.what());
    }
  }
  try {
    PlaceViews views = MakeViews(scene, config);
    WritePlaceViews(file, views, key);
    return views;
  } catch (const sim::FileError&) {
    throw;
  } catch (const sim::Error& e) {
    throw sim::FileError(scene, "", e.what());
  }
}

std::vector<PlaceViews> AllPlaceViews(const PlaceDataConfig& config,
                                      const std::function<void()>& on_scene) {
  const std::vector<fs::path> scenes = ScenesOf(config);
  std::vector<PlaceViews> views(scenes.size());
  sim::WorkerPool pool(0);
  pool.ForEach(static_cast<int>(scenes.size()), [&](int task, int /*worker*/) {
    const auto place = static_cast<std::size_t>(task);
    views[place] = PlaceViewsOf(scenes[place], config);
    if (on_scene) on_scene();
  });
  return views;
}

}  // namespace bulletnav::bench
