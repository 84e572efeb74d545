// SPDX-License-Identifier: MIT
#include "agent/nts/nts_agent.h"

#include <algorithm>
#include <array>

#include "agent/nts/view_ghosts.h"
#include "agent/perception/relative_pose.h"
#include "sim/base/elementary.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

constexpr int kFirstNode = 1 << 20;   // nodes' numbers for the watch, which has ghosts' below
constexpr double kSurprise = 0.5;     // metres that the map's way is longer than was believed
constexpr double kNowhereToGo = 0.1;  // metres to a waypoint

ApproachSpec ApproachBy(const PolicySpec& policy) {
  ApproachSpec spec = ApproachOf(policy);
  spec.patience = policy.patience;
  spec.least_progress = policy.least_progress;
  spec.miss_within = policy.miss_within;
  spec.misses = policy.misses;
  return spec;
}

}  // namespace

NtsAgent::NtsAgent(const Config& config, const AgentContext& context, GhostChoice choice)
    : spec_(config),
      model_(context.models.Need<SemanticModel>(kSemanticModel)),
      navigator_(context.rig, config.navigator, context.models.Find<FreeSpaceModel>(kMapper)),
      update_(config.graph, model_),
      policy_(config.policy, model_, choice),
      watch_(config.policy.patience, config.policy.least_progress),
      choice_(choice),
      approach_(ApproachBy(config.policy)) {}

void NtsAgent::Reset(const Panorama& goal, std::uint64_t seed) {
  navigator_.Reset();
  update_.Reset();
  given_up_.clear();
  NextGoal(goal, seed);
}

void NtsAgent::NextGoal(const Panorama& goal, std::uint64_t seed) {
  policy_.NewGoal(model_->Encode({&goal, 1}).front(), seed);
  rng_ = sim::Rng(seed, "nts agent");
  watch_.Reset();
  approach_.Reset();
  target_.reset();
  subgoal_.reset();
}

sim::Action NtsAgent::Act(const Observation& observation) {
  navigator_.Observe(observation);
  const PanoramaCode code = model_->Encode({&observation.panorama, 1}).front();
  update_.Observe(code, navigator_.pose());
  for (GivenUp& given_up : given_up_) {
    given_up.point = update_.MovedWith(given_up.owner, given_up.point);
  }
  if (update_.localisation().is_new) AddOpenings();
  policy_.Read(&update_.graph());
  LookForGoal(code);
  target_ = approach_.target();
  subgoal_.reset();
  std::optional<sim::Action> action = approach_.Act(&navigator_);
  if (!action) target_.reset();
  if (!action) action = Travel(code);
  if (!action) action = Wander();
  navigator_.Took(*action);
  return *action;
}

void NtsAgent::LookForGoal(const PanoramaCode& code) {
  const std::array<const PanoramaCode*, 1> here = {&code};
  view_ = model_->Compare(here, policy_.goal()).front();
  const bool sees_goal = view_.same_node >= spec_.policy.goal_seen;
  approach_.See(sees_goal ? std::optional(RelativePoseOf(view_)) : std::nullopt, navigator_);
}

std::optional<sim::Action> NtsAgent::Travel(const PanoramaCode& code) {
  constexpr int kTries = 8;
  DropKnownGhosts();
  for (int i = 0; i < kTries; ++i) {
    policy_.Read(&update_.graph());
    const std::optional<Waypoint> plan = Choose();
    if (TakeView(code, subgoal_)) continue;
    if (!subgoal_) return std::nullopt;
    if (IsGhostReached(*subgoal_)) {
      update_.graph().RemoveGhost(*subgoal_->ghost);
      MakeNode(code);
      continue;
    }
    if (const auto action = Walk(*subgoal_, plan)) {
      policy_.Follow(*subgoal_);
      return action;
    }
    GiveUp(*subgoal_);
  }
  return std::nullopt;
}

std::optional<Waypoint> NtsAgent::Choose() {
  constexpr int kQuestions = 12;
  for (int i = 0;; ++i) {
    subgoal_ =
        policy_.Choose(update_.graph(), update_.localisation(), navigator_.here(), approach_);
    if (!subgoal_) return std::nullopt;
    const std::optional<Waypoint> plan = navigator_.Plan(subgoal_->point, true);
    if (!plan || !subgoal_->ghost || !subgoal_->is_last()) return plan;
    if (choice_ == GhostChoice::kRandom) return plan;
    policy_.known_ways().Learn(navigator_.here(), subgoal_->point, plan->distance);
    if (plan->distance <= subgoal_->way + kSurprise || i == kQuestions) return plan;
  }
}

bool NtsAgent::TakeView(const PanoramaCode& code, const std::optional<Subgoal>& known) {
  const bool is_led = known && !known->ghost;
  if (is_led || update_.localisation().is_new || choice_ == GhostChoice::kRandom) return false;
  std::vector<Opening> openings;
  for (const Point& point : NewOpenings()) openings.push_back(SeenFromBody(point));
  for (const ViewGhost& ghost :
       GhostsOfView(spec_, model_->Explorable(code), view_.score, openings)) {
    const Point point = navigator_.PointAt(ghost.distance, ghost.bearing);
    const double all =
        policy_.AllOfView(update_.graph(), update_.localisation(), navigator_.here(), ghost, point);
    if (known && all >= known->all - spec_.policy.view_margin) continue;
    const bool is_opening = ghost.distance < kNodeRadius;
    if (!is_opening && IsKnown(point)) continue;
    MakeNode(code);
    if (!is_opening) {
      update_.graph().AddGhost(update_.localisation().current, DirectionOf(ghost.bearing));
    }
    return true;
  }
  return false;
}

void NtsAgent::MakeNode(const PanoramaCode& code) {
  update_.MakeNode(code, navigator_.pose());
  AddOpenings();
}

void NtsAgent::AddOpenings() {
  for (const Point& opening : NewOpenings()) {
    update_.graph().AddGhostAt(update_.localisation().current, opening);
  }
}

std::vector<Point> NtsAgent::NewOpenings() {
  if (spec_.policy.opening_reach == 0.0) return {};
  const double clearance = spec_.policy.opening_clearance;
  std::vector<Point> openings = navigator_.Openings(spec_.policy.opening_reach, clearance);
  const TopologicalGraph& graph = update_.graph();
  std::erase_if(openings, [&](const Point& opening) {
    const auto is_near = [&](const GhostNode& ghost) {
      return Distance(opening, graph.GhostPoint(ghost)) < clearance;
    };
    return IsVisited(opening, spec_.policy.near_reached) || IsGivenUp(opening) ||
           std::any_of(graph.ghosts().begin(), graph.ghosts().end(), is_near);
  });
  return openings;
}

Opening NtsAgent::SeenFromBody(const Point& point) const {
  const sim::PlanarPose& pose = navigator_.pose();
  const double heading = sim::Atan2(point.y - pose.y, point.x - pose.x);
  return {sim::WrapAngle(heading - pose.yaw), Distance(point, navigator_.here())};
}

void NtsAgent::DropKnownGhosts() {
  const std::vector<GhostNode> ghosts = update_.graph().ghosts();
  for (const GhostNode& ghost : ghosts) {
    const Point point = update_.graph().GhostPoint(ghost);
    if (IsSeen(point) || IsGivenUp(point)) update_.graph().RemoveGhost(ghost.id);
  }
}

bool NtsAgent::IsSeen(const Point& ghost) const {
  const double radius = spec_.policy.ghost_frontier;
  return radius > 0.0 && !navigator_.MayLeadOn(ghost, radius);
}

bool NtsAgent::IsKnown(const Point& point) const {
  return IsVisited(point, spec_.graph.ghost_clearance) || IsSeen(point) || IsGivenUp(point);
}

bool NtsAgent::IsVisited(const Point& point, double radius) const {
  for (int i = 0; i < static_cast<int>(update_.graph().nodes().size()); ++i) {
    if (Distance(point, update_.graph().NodePoint(i)) < radius) return true;
  }
  return false;
}

bool NtsAgent::IsGivenUp(const Point& point) const {
  return std::any_of(given_up_.begin(), given_up_.end(), [&](const GivenUp& other) {
    return Distance(point, other.point) < spec_.graph.ghost_clearance;
  });
}

bool NtsAgent::IsGhostReached(const Subgoal& subgoal) const {
  if (!subgoal.ghost || !subgoal.is_last()) return false;
  const GhostNode* ghost = update_.graph().FindGhost(*subgoal.ghost);
  const bool is_near = ghost != nullptr && ghost->distance < kNodeRadius;
  return Distance(subgoal.point, navigator_.here()) <=
         (is_near ? spec_.policy.near_reached : spec_.policy.ghost_reached);
}

/// Absent if it cannot be walked to, or the goal is not there.
std::optional<sim::Action> NtsAgent::Walk(const Subgoal& subgoal, std::optional<Waypoint> plan) {
  target_ = subgoal.point;
  const bool is_goal = !subgoal.ghost && subgoal.is_last();
  if (is_goal && Distance(subgoal.point, navigator_.here()) <= spec_.policy.node_reached) {
    return std::nullopt;
  }
  if (!plan) {
    navigator_.ForgetMap();
    policy_.known_ways().Clear();
    plan = navigator_.Plan(subgoal.point, true);
  }
  if (!plan || Distance(plan->point, navigator_.here()) < kNowhereToGo) return std::nullopt;
  if (is_goal && approach_.Misses(subgoal.point, plan->distance, navigator_)) return std::nullopt;
  // Ways over the graph and over the map are not measured alike.
  const int number = 2 * subgoal.ghost.value_or(subgoal.path.back() + kFirstNode);
  const double seen = is_goal ? navigator_.seen_area() : 0.0;
  const bool is_stuck = subgoal.is_last() ? watch_.IsStuck(number, plan->distance, seen)
                                          : watch_.IsStuck(number + 1, subgoal.way);
  if (is_stuck) return std::nullopt;
  return navigator_.Steer(plan->point);
}

void NtsAgent::GiveUp(const Subgoal& subgoal) {
  if (!subgoal.is_last()) {
    update_.graph().RemoveEdge(subgoal.path[0], subgoal.path[1]);
  } else if (subgoal.ghost) {
    const GhostNode* ghost = update_.graph().FindGhost(*subgoal.ghost);
    given_up_.push_back({subgoal.point, ghost != nullptr ? ghost->owner : -1});
    update_.graph().RemoveGhost(*subgoal.ghost);
  } else {
    policy_.Refute(subgoal.path[0]);
    approach_.RefuteAt(subgoal.point);
  }
}

sim::Action NtsAgent::Wander() {
  subgoal_.reset();
  const auto plan = navigator_.ToFrontier();
  target_ = navigator_.frontier();
  if (plan) return navigator_.Steer(plan->point);
  // Nothing is left to explore: something that was done away with on the way was wrong.
  target_.reset();
  navigator_.ForgetMap();
  policy_.known_ways().Clear();
  given_up_.clear();
  policy_.Reconsider();
  approach_.Reconsider();
  return rng_.Chance(0.5) ? sim::Action::kMoveForward : sim::Action::kTurnLeft;
}

Belief NtsAgent::belief() const {
  Belief belief{navigator_.pose(), std::nullopt, navigator_.map().Picture()};
  if (target_) belief.target = sim::PlanarPose{target_->x, target_->y, 0.0};
  belief.graph = update_.graph().Picture();
  if (!subgoal_) return belief;
  belief.graph->path = subgoal_->path;
  const auto& ghosts = update_.graph().ghosts();
  for (std::size_t i = 0; subgoal_->ghost && i < ghosts.size(); ++i) {
    if (ghosts[i].id != *subgoal_->ghost) continue;
    belief.graph->path.push_back(static_cast<int>(update_.graph().nodes().size() + i));
  }
  return belief;
}

}  // namespace bulletnav::agent
