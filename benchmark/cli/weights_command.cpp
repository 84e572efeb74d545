// SPDX-License-Identifier: MIT
#include <bit>
#include <charconv>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <sstream>
#include <string>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/core.h>

#include "agent/integer/quantised_file.h"
#include "agent/models/safetensors.h"
#include "benchmark/cli/commands.h"
#include "benchmark/runs/agent_models.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

struct WeightsOptions {
  std::string file;
  fs::path integers_only;
};

/// How many numbers of a file have names that begin so, or that do not.
std::size_t CountNumbers(const agent::TensorFile& content, bool integers) {
  std::size_t count = 0;
  for (const auto& [name, tensor] : content.tensors) {
    if (name.starts_with(agent::kIntegerPrefix) == integers) count += tensor.values.size();
  }
  return count;
}

/// Some numbers are kept as the bits of a double.
std::string Readable(const std::string& key, const std::string& text) {
  std::uint64_t bits = 0;
  const char* end = text.data() + text.size();
  const auto [last, error] = std::from_chars(text.data(), end, bits);
  const bool is_bits = key.starts_with("return.") && error == std::errc() && last == end;
  return is_bits ? fmt::format("{}", std::bit_cast<double>(bits)) : text;
}

/// Its lines, set in; of one line, in the same line.
void PrintEntry(const std::string& key, const std::string& text) {
  if (text.find('\n') == std::string::npos) {
    fmt::print("{:<18}{}\n", key, text);
    return;
  }
  fmt::print("{}:\n", key);
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) fmt::print("  {}\n", line);
}

void TellWeights(const fs::path& file) {
  const agent::TensorFile content = agent::ReadTensorFile(file);
  PrintEntry("file", file.string());
  PrintEntry("megabytes", fmt::format("{:.1f}", static_cast<double>(fs::file_size(file)) / 1e6));
  PrintEntry("trained numbers", std::to_string(CountNumbers(content, false)));
  PrintEntry("in integers", std::to_string(CountNumbers(content, true)));
  for (const auto& [key, text] : content.metadata) PrintEntry(key, Readable(key, text));
}

}  // namespace

void AddWeightsCommand(CLI::App* program) {
  auto options = std::make_shared<WeightsOptions>();
  CLI::App* command = program->add_subcommand(
      "weights", "What a file of weights holds: its network, how it was trained, its numbers");
  command->add_option("file", options->file, "A .safetensors file that train has written")
      ->required();
  command->add_option("--integers-only", options->integers_only,
                      "Write FILE with the network in integers alone: smaller, the same answers, "
                      "but not to be trained on");
  command->callback([options] {
    const fs::path file = FindWeights(options->file);
    if (options->integers_only.empty()) {
      TellWeights(file);
      return;
    }
    agent::KeepIntegersAlone(file, options->integers_only);
    TellWeights(options->integers_only);
  });
}

}  // namespace bulletnav::bench
