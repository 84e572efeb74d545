// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <span>

#include "benchmark/evaluate_perception/perception_cases.h"
#include "benchmark/evaluate_perception/perception_config.h"

namespace bulletnav::bench {

/// Draws config.pictures examples, each of another scene while there are some, by config.seed and
/// not by how well the model does: explorable-N, relative_pose-N, scores-N and choices-N, as PNG
/// and SVG in `folder`; see example_figures.h. Kinds that a scene has no example of are left out.
/// `on_example` is called after each. Throws sim::FileError.
void DrawExamples(std::span<const SceneCases> scenes, const PerceptionConfig& config,
                  const std::filesystem::path& folder, const std::function<void()>& on_example);

}  // namespace bulletnav::bench
