// SPDX-License-Identifier: MIT
#include "benchmark/episodes/episode_file.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "benchmark/base/gzip.h"
#include "benchmark/episodes/episode_json.h"
#include "sim/base/error.h"
#include "sim/base/files.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;
using sim::Error;
using sim::FileError;

std::string ReadText(const fs::path& file) {
  const std::vector<std::uint8_t> bytes = sim::ReadFile(file);
  if (bytes.empty()) throw FileError(file, "", "is empty; copy or make it again");
  if (!IsGzip(bytes)) return {bytes.begin(), bytes.end()};
  try {
    return Decompress(bytes);
  } catch (const Error& e) {
    throw FileError(file, "", e.what());
  }
}

/// How messages call an episode: by its id if it has one.
std::string OwnerName(const Json& episode, std::size_t i) {
  const auto id = episode.is_object() ? episode.find("episode_id") : episode.end();
  if (!episode.is_object() || id == episode.end() || !id->is_string()) {
    return "episodes[" + std::to_string(i) + "]";
  }
  return "episode '" + id->get<std::string>() + "'";
}

std::vector<Episode> ParseList(const JsonCursor& list, const fs::path& file) {
  std::vector<Episode> episodes;
  for (std::size_t i = 0; i < list.Size(); ++i) {
    const Json json = ToHabitatForm(list.value()[i]);
    episodes.push_back(EpisodeFromJson({json, file, OwnerName(json, i)}));
  }
  return episodes;
}

/// The id as a number of the list format, if it is one.
std::optional<std::size_t> IdNumber(const std::string& id) {
  std::size_t number = 0;
  const char* end = id.data() + id.size();
  const auto [stop, error] = std::from_chars(id.data(), end, number);
  if (error != std::errc() || stop != end || std::to_string(number) != id) return std::nullopt;
  return number;
}

Json ToJson(const EpisodeSet& set, EpisodeFormat format) {
  const auto& episodes = set.episodes;
  const bool numbered = std::all_of(episodes.begin(), episodes.end(), [](const Episode& episode) {
    return IdNumber(episode.id).has_value();
  });
  Json list = Json::array();
  for (std::size_t i = 0; i < episodes.size(); ++i) {
    const std::size_t number = numbered ? *IdNumber(episodes[i].id) : i;
    list.push_back(FromHabitatForm(EpisodeToJson(episodes[i]), format, number));
  }
  if (format == EpisodeFormat::kList) return list;
  Json whole = set.other.empty() ? Json::object() : Json::parse(set.other);
  whole["episodes"] = std::move(list);
  return whole;
}

/// What a scene's file may be called, the best first.
std::vector<std::string> NamesOf(const std::string& scene) {
  constexpr std::string_view kHabitatFolder = "data/scene_datasets/";
  constexpr std::string_view kBasis = ".basis.glb";
  std::vector<std::string> names;
  if (scene.ends_with(kBasis)) {
    names.push_back(scene.substr(0, scene.size() - kBasis.size()) + ".glb");
  }
  names.push_back(scene);
  if (!scene.starts_with(kHabitatFolder)) return names;
  for (const std::string& name : std::vector<std::string>(names)) {
    names.push_back(name.substr(kHabitatFolder.size()));
  }
  return names;
}

}  // namespace

EpisodeSet ReadEpisodes(const fs::path& file) {
  Json json = ParseJson(ReadText(file), file);
  const JsonCursor whole(json, file);
  EpisodeSet set;
  if (json.is_array()) {
    set.episodes = ParseList(whole, file);
  } else {
    set.episodes = ParseList(whole.At("episodes"), file);
    // Its place among the other keys stays marked.
    json["episodes"] = nullptr;
    if (json.size() > 1) set.other = json.dump();
  }
  if (set.episodes.empty()) {
    throw FileError(file, "", "holds no episodes; a set split by scene has them in other files");
  }
  RequireUniqueIds(set.episodes, file);
  return set;
}

void WriteEpisodes(const fs::path& file, const EpisodeSet& set, EpisodeFormat format) {
  const std::string text = ToJson(set, format).dump();
  if (file.extension() == ".gz") {
    sim::WriteFileAtomically(file, Compress(text));
  } else {
    sim::WriteFileAtomically(file, text);
  }
}

void RequireUniqueIds(const std::vector<Episode>& episodes, const fs::path& file) {
  std::map<std::pair<std::string, std::string>, std::size_t> seen;
  for (std::size_t i = 0; i < episodes.size(); ++i) {
    const auto [first, is_new] = seen.try_emplace({episodes[i].scene, episodes[i].id}, i);
    if (is_new) continue;
    throw FileError(file, " episode '" + episodes[i].id + "'",
                    "episodes[" + std::to_string(i) + "] has the id of episodes[" +
                        std::to_string(first->second) + "] in scene " + episodes[i].scene +
                        "; remove or rename one");
  }
}

fs::path FindScene(const std::string& scene, const std::vector<fs::path>& folders) {
  std::string tried;
  for (const std::string& name : NamesOf(scene)) {
    if (fs::is_regular_file(name)) return name;
    for (const fs::path& folder : folders) {
      if (fs::is_regular_file(folder / name)) return folder / name;
      tried += ", " + (folder / name).string();
    }
  }
  throw Error("scene " + scene + ": no such file" +
              (tried.empty() ? "" : ", nor" + tried.substr(1)) +
              "; make or fetch the scene, or name the folder it is in");
}

}  // namespace bulletnav::bench
