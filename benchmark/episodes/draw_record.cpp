// SPDX-License-Identifier: MIT
#include "benchmark/episodes/draw_record.h"

#include <optional>

#include <fmt/core.h>

#include "benchmark/base/file_hash.h"
#include "benchmark/base/json_cursor.h"
#include "sim/base/error.h"
#include "sim/config/yaml_writer.h"

namespace bulletnav::bench {
namespace {

constexpr const char* kKey = "drawn_from";
constexpr const char* kRemedy =
    "; remove the file to have it drawn again, or give episodes another file";

/// Of how scenes are made to look, what changes where one can walk.
std::optional<sim::Finish> ShapeOf(const std::optional<sim::Finish>& finish) {
  if (!finish || finish->ceiling) return std::nullopt;
  sim::Finish shape;
  shape.ceiling = false;
  return shape;
}

Json Record(GeneratorSpec spec, const std::vector<std::string>& scenes) {
  spec.out.clear();
  spec.import.finish = ShapeOf(spec.import.finish);
  Json hashes = Json::object();
  for (const std::string& scene : scenes) {
    hashes[scene] = FileHash(scene);
  }
  return {{"spec", sim::ToYaml(spec)}, {"scenes", hashes}};
}

}  // namespace

std::string DrawRecord(const GeneratorSpec& spec, const std::vector<std::string>& scenes) {
  return Json{{kKey, Record(spec, scenes)}}.dump();
}

void RequireDrawnFrom(const EpisodeSet& set, const GeneratorSpec& spec,
                      const std::filesystem::path& file) {
  const Json other = set.other.empty() ? Json::object() : Json::parse(set.other);
  const auto saved = other.find(kKey);
  if (saved == other.end() || !saved->is_object()) return;
  const Json now = Record(spec, ScenesOf(spec));
  if (saved->value("spec", Json()) != now["spec"]) {
    throw sim::FileError(file, "", fmt::format("was drawn by another config{}", kRemedy));
  }
  if (saved->value("scenes", Json()) != now["scenes"]) {
    throw sim::FileError(file, "", fmt::format("was drawn in other scenes{}", kRemedy));
  }
}

}  // namespace bulletnav::bench
