// SPDX-License-Identifier: MIT
// The commands that need torch, in a program of their own: see forwarded_commands.cpp.
#include <cstdlib>

#include "agent/perception/learned_mapper.h"
#include "agent/perception/learned_model.h"
#include "benchmark/cli/commands.h"
#include "benchmark/cli/hand_over.h"
#include "benchmark/cli/program.h"

namespace {

using bulletnav::agent::Rig;

bulletnav::bench::ModelLoaders Loaders() {
  return {[](const std::filesystem::path& weights, const Rig& rig) {
            return std::make_shared<bulletnav::agent::LearnedModel>(weights, rig);
          },
          [](const std::filesystem::path& weights, const Rig& rig) {
            return std::make_shared<bulletnav::agent::LearnedMapper>(weights, rig);
          }};
}

}  // namespace

int main(int argc, char** argv) {
  return bulletnav::bench::RunProgram(argc, argv, [](CLI::App* program) {
    // Started by itself: OpenBLAS has to be set up before it is loaded, see HandOverToLearn.
    if (std::getenv("OPENBLAS_NUM_THREADS") == nullptr) bulletnav::bench::HandOverToLearn();
    bulletnav::bench::AddTrainCommand(program);
    bulletnav::bench::AddEvaluatePerceptionCommand(program);
    bulletnav::bench::AddRunCommand(program, Loaders());
  });
}
