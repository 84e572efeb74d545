// SPDX-License-Identifier: MIT
#include "sim/house/floor_plan_generator.h"

#include <algorithm>
#include <optional>

#include "sim/base/check.h"
#include "sim/base/error.h"
#include "sim/house/plan/archetypes.h"
#include "sim/house/plan/assemble.h"
#include "sim/house/plan/doors.h"
#include "sim/house/plan/judge.h"
#include "sim/house/plan/links.h"
#include "sim/house/plan/passage.h"
#include "sim/house/plan/program.h"
#include "sim/house/plan/review.h"
#include "sim/house/plan/windows.h"

namespace bulletnav::sim {
namespace {

using plan::Layout;

constexpr int kRounds = 200;          // programmes tried before giving up; a few suffice
constexpr int kTries = 600;           // drafts of one programme
constexpr float kBodyRadius = 0.24f;  // the agent's 0.18 m and slack
constexpr std::size_t kEnough = 14;   // good layouts to choose from

/// Good layouts of one programme, the best first.
std::vector<Layout> GoodLayouts(const plan::Program& program, const plan::Traits& traits,
                                const PlanOptions& options, Rng* rng) {
  std::vector<Layout> layouts;
  for (int i = 0; i < kTries && layouts.size() < kEnough; ++i) {
    const std::optional<plan::Draft> draft = plan::DrawDraft(program, traits, rng);
    if (!draft) continue;
    std::optional<Layout> layout = plan::Judge(*draft, options);
    if (layout) layouts.push_back(*std::move(layout));
  }
  std::stable_sort(layouts.begin(), layouts.end(), [](const Layout& a, const Layout& b) {
    return a.penalty < b.penalty;
  });
  return layouts;
}

std::optional<FloorPlan> Furnish(const Layout& layout, Rng* rng) {
  const float ceiling = 0.05f * static_cast<float>(rng->Between(48, 60));
  const auto links = plan::DrawLinks(layout, rng->Uniform(0.35, 1.0), rng);
  if (!links) return std::nullopt;
  plan::DoorStyle door_style;
  // Heads lie in one line or clearly apart.
  const auto draw_top = [&](double high) {
    return rng->Chance(0.4) ? door_style.door_top : static_cast<float>(rng->Uniform(2.18, high));
  };
  door_style.arch_top = std::min(ceiling - 0.25f, draw_top(2.4));
  auto openings = plan::PlaceDoors(layout, *links, door_style, rng);
  if (!openings) return std::nullopt;
  plan::WindowStyle window_style;
  window_style.head = std::min(ceiling - 0.2f, draw_top(2.3));
  window_style.scale = static_cast<float>(rng->Uniform(0.85, 1.25));
  window_style.low_sill = rng->Chance(0.3) ? 0.25f : 0.0f;
  window_style.is_flat = rng->Chance(0.3);
  const auto windows = plan::PlaceWindows(layout, *openings, window_style, rng);
  openings->insert(openings->end(), windows.begin(), windows.end());
  FloorPlan plan = plan::Assemble(layout, *std::move(openings));
  if (!plan::IsLivable(plan) || !plan::IsPassable(plan, kBodyRadius)) return std::nullopt;
  plan.ceiling = ceiling;
  plan::Turn(rng->Below(8), &plan);
  return plan;
}

}  // namespace

void PlanOptions::Validate() const {
  if (min_rooms < 5 || max_rooms > 12 || min_rooms > max_rooms) {
    throw Error("min_rooms and max_rooms must be in order, between 5 and 12");
  }
  if (min_area_m2 < 60.0f || max_area_m2 > 200.0f || max_area_m2 < min_area_m2 + 20.0f) {
    throw Error("min_area_m2 and max_area_m2 must lie between 60 and 200, at least 20 apart");
  }
}

FloorPlan GenerateFloorPlan(const Rng& rng, const PlanOptions& options) {
  options.Validate();
  for (int round = 0; round < kRounds; ++round) {
    Rng draw = rng.Fork("plan", static_cast<std::uint64_t>(round));
    const plan::Program program = plan::DrawProgram(options, &draw);
    const plan::Traits traits = plan::DrawTraits(program, options, &draw);
    for (const Layout& layout : GoodLayouts(program, traits, options, &draw)) {
      std::optional<FloorPlan> plan = Furnish(layout, &draw);
      if (plan) return *std::move(plan);
    }
  }
  throw Error("no floor plan fits the options");
}

}  // namespace bulletnav::sim
