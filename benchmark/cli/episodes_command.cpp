// SPDX-License-Identifier: MIT
#include <memory>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/core.h>

#include "benchmark/base/warn_line.h"
#include "benchmark/cli/commands.h"
#include "benchmark/cli/progress.h"
#include "benchmark/cli/scene_options.h"
#include "benchmark/cli/shipped_config.h"
#include "benchmark/episodes/description.h"
#include "benchmark/episodes/draw_record.h"
#include "benchmark/episodes/episode_file.h"
#include "benchmark/episodes/generator.h"
#include "benchmark/episodes/merge.h"
#include "sim/base/require_writable.h"
#include "sim/config/yaml_reader.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

struct GenerateOptions {
  fs::path config;
  fs::path out;
  int workers = 0;
};

struct ConvertOptions {
  std::vector<fs::path> files;
  EpisodeFormat format = EpisodeFormat::kHabitat;
  fs::path out;
};

void Generate(const GenerateOptions& options) {
  const auto spec = sim::LoadYaml<GeneratorSpec>(ShippedConfig(options.config));
  const fs::path out = options.out.empty() ? fs::path(spec.out) : options.out;
  sim::RequireWritable(out);
  const std::vector<std::string> scenes = ScenesOf(spec);
  WarnOfScenesLeftOut(spec, scenes, WarnLine);
  EpisodeSet set;
  {
    Progress progress("scenes", static_cast<int>(scenes.size()));
    set.episodes = GenerateEpisodes(spec, scenes, options.workers, [&] {
      progress.Advance();
    });
  }
  set.other = DrawRecord(spec, scenes);
  WriteEpisodes(out, set);
  fmt::print("{} episodes in {}\n", set.episodes.size(), out.string());
}

void Convert(const ConvertOptions& options) {
  std::vector<NamedEpisodeSet> files;
  for (const fs::path& file : options.files) files.push_back({file, ReadEpisodes(file)});
  const MergedEpisodes merged = MergeEpisodes(std::move(files));
  WriteEpisodes(options.out, merged.set, options.format);
  fmt::print("{} episodes in {}\n", merged.set.episodes.size(), options.out.string());
  if (merged.renamed > 0) {
    fmt::print("{} had ids that other files use too; their files' names now stand before them\n",
               merged.renamed);
  }
}

void AddGenerate(CLI::App* episodes) {
  auto options = std::make_shared<GenerateOptions>();
  CLI::App* command = episodes->add_subcommand(
      "generate", "Draw easy, medium, hard and sequential-goal episodes in scenes");
  command->add_option("config", options->config, "YAML file, as configs/episodes.yaml")->required();
  command->add_option("--out", options->out, "File to write instead of the config's");
  command->add_option("--workers", options->workers, "Threads (default: one per processor)")
      ->check(CLI::Range(1, 1024));
  command->callback([options] {
    Generate(*options);
  });
}

void AddConvert(CLI::App* episodes, bool is_export) {
  auto options = std::make_shared<ConvertOptions>();
  CLI::App* command =
      is_export ? episodes->add_subcommand("export", "Write episodes for other programs")
                : episodes->add_subcommand("import",
                                           "Turn files of Habitat, image-goal-nav-dataset or NRNS, "
                                           "one or many, into one file of episodes");
  command->add_option("files", options->files, "Episode files: .json or .json.gz")->required();
  if (is_export) AddEnumOption(command, "--format", &options->format, "Whose form");
  command->add_option("--out", options->out, "File to write; compressed if it ends in .gz")
      ->required();
  command->callback([options] {
    Convert(*options);
  });
}

void AddShow(CLI::App* episodes) {
  auto file = std::make_shared<fs::path>();
  CLI::App* command =
      episodes->add_subcommand("show", "Count a file's episodes and draw their distances as text");
  command->add_option("file", *file, "Episode file")->required();
  command->callback([file] {
    fmt::print("{}", DescribeEpisodes(ReadEpisodes(*file).episodes));
  });
}

}  // namespace

void AddEpisodesCommand(CLI::App* program) {
  CLI::App* episodes = program->add_subcommand("episodes", "Make, convert and inspect episodes");
  episodes->require_subcommand(1);
  AddGenerate(episodes);
  AddConvert(episodes, false);
  AddConvert(episodes, true);
  AddShow(episodes);
}

}  // namespace bulletnav::bench
