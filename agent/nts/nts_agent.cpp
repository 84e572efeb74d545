// SPDX-License-Identifier: MIT
#include "agent/nts/nts_agent.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "agent/nts/view_ghosts.h"
#include "agent/perception/relative_pose.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

constexpr int kGoalItself = -1;       // for the watch, which tells ghosts and nodes by number
constexpr int kFirstNode = 1 << 20;   // nodes' numbers there
constexpr double kSlack = 0.3;        // metres that a way may be longer than straight
constexpr double kNowhereToGo = 0.1;  // metres to a waypoint

}  // namespace

std::shared_ptr<SemanticModel> RequireModel(const AgentContext& context, std::string_view agent) {
  if (context.semantic_model) return context.semantic_model;
  throw sim::Error(std::string(agent) +
                   " needs somebody to answer its four functions; semantic_model: learned (or "
                   "oracle) in a run's config says who");
}

NtsAgent::NtsAgent(const Config& config, const AgentContext& context, std::string_view name,
                   GhostChoice choice)
    : spec_(config),
      model_(RequireModel(context, name)),
      navigator_(context.rig, config.navigator, context.mapper),
      update_(config.graph, model_),
      policy_(config.policy, model_, choice),
      watch_(config.policy.patience, config.policy.least_progress),
      choice_(choice),
      goal_(config.policy.sightings, config.policy.stop_certainty) {}

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
  sees_goal_ = false;
  goal_.Reset();
  target_.reset();
  subgoal_.reset();
}

sim::Action NtsAgent::Act(const Observation& observation) {
  navigator_.Observe(observation);
  const PanoramaCode code = model_->Encode({&observation.panorama, 1}).front();
  update_.Observe(code, navigator_.pose());
  if (update_.localisation().is_new) AddOpenings();
  policy_.Read(&update_.graph());
  LookForGoal(code);
  target_.reset();
  subgoal_.reset();
  std::optional<sim::Action> action = Approach();
  if (!action) action = Travel(code);
  if (!action) action = Wander();
  navigator_.Took(*action);
  return *action;
}

void NtsAgent::LookForGoal(const PanoramaCode& code) {
  const std::array<const PanoramaCode*, 1> here = {&code};
  view_ = model_->Compare(here, policy_.goal()).front();
  sees_goal_ = view_.same_node >= spec_.policy.goal_seen;
  if (!sees_goal_) return;
  const RelativeGoal goal = RelativePoseOf(view_);
  goal_.Add(navigator_.PointAt(goal.distance, goal.bearing), goal.distance, goal.certainty);
}

std::optional<sim::Action> NtsAgent::Approach() {
  target_ = goal_.point();
  if (!target_) return std::nullopt;
  const double distance = Distance(*target_, navigator_.here());
  const bool is_certain = view_.same_node >= spec_.policy.stop_certainty;
  const bool is_there = is_certain && distance <= spec_.policy.stop_distance;
  const auto plan = navigator_.Plan(*target_, true);
  const bool is_stuck = plan && watch_.IsStuck(kGoalItself, plan->distance);
  // A sight of the goal across something that has to be gone round is no arrival.
  const bool is_astray = plan && !is_stuck && plan->distance > spec_.policy.stop_distance + kSlack;
  if (is_there && !is_astray) return sim::Action::kStop;
  // Odometry has smeared the map until it left no way.
  if (is_stuck || !plan) navigator_.ForgetMap();
  const bool is_wrong = !is_certain && (is_stuck || distance <= kAtGoal);
  if (!plan || is_wrong) {
    goal_.Refute();
    return std::nullopt;
  }
  return navigator_.Steer(plan->point);
}

std::optional<sim::Action> NtsAgent::Travel(const PanoramaCode& code) {
  constexpr int kTries = 8;
  DropSeenGhosts();
  for (int i = 0; i < kTries; ++i) {
    policy_.Read(&update_.graph());
    subgoal_ = policy_.Choose(update_.graph(), update_.localisation(), navigator_.here());
    if (TakeView(code, subgoal_)) continue;
    if (!subgoal_) return std::nullopt;
    if (IsGhostReached(*subgoal_)) {
      update_.graph().RemoveGhost(*subgoal_->ghost);
      MakeNode(code);
      continue;
    }
    if (const auto action = Walk(*subgoal_)) return action;
    GiveUp(*subgoal_);
  }
  return std::nullopt;
}

bool NtsAgent::TakeView(const PanoramaCode& code, const std::optional<Subgoal>& known) {
  const bool is_led = known && !known->ghost;
  if (is_led || update_.localisation().is_new || choice_ == GhostChoice::kRandom) return false;
  std::vector<Opening> openings;
  for (const Point& point : NewOpenings()) openings.push_back(SeenFromBody(point));
  for (const ViewGhost& ghost :
       GhostsOfView(spec_, model_->Explorable(code), view_.score, openings)) {
    if (known && ghost.way >= known->all - spec_.policy.view_margin) return false;
    const Point point = navigator_.PointAt(ghost.distance, ghost.bearing);
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
  const double heading = std::atan2(point.y - pose.y, point.x - pose.x);
  return {sim::WrapAngle(heading - pose.yaw), Distance(point, navigator_.here())};
}

void NtsAgent::DropSeenGhosts() {
  const std::vector<GhostNode> ghosts = update_.graph().ghosts();
  for (const GhostNode& ghost : ghosts) {
    if (IsSeen(update_.graph().GhostPoint(ghost))) update_.graph().RemoveGhost(ghost.id);
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
  return std::any_of(given_up_.begin(), given_up_.end(), [&](const Point& other) {
    return Distance(point, other) < spec_.graph.ghost_clearance;
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
std::optional<sim::Action> NtsAgent::Walk(const Subgoal& subgoal) {
  target_ = subgoal.point;
  const bool is_goal = !subgoal.ghost && subgoal.is_last();
  if (is_goal && Distance(subgoal.point, navigator_.here()) <= spec_.policy.node_reached) {
    return std::nullopt;
  }
  auto plan = navigator_.Plan(subgoal.point, true);
  if (!plan) {
    navigator_.ForgetMap();
    plan = navigator_.Plan(subgoal.point, true);
  }
  if (!plan || Distance(plan->point, navigator_.here()) < kNowhereToGo) return std::nullopt;
  const int number = subgoal.ghost.value_or(subgoal.path.back() + kFirstNode);
  const double left = subgoal.is_last() ? plan->distance : subgoal.way;
  if (watch_.IsStuck(number, left)) return std::nullopt;
  return navigator_.Steer(plan->point);
}

void NtsAgent::GiveUp(const Subgoal& subgoal) {
  if (!subgoal.is_last()) {
    update_.graph().RemoveEdge(subgoal.path[0], subgoal.path[1]);
  } else if (subgoal.ghost) {
    given_up_.push_back(subgoal.point);
    update_.graph().RemoveGhost(*subgoal.ghost);
  } else {
    policy_.Refute(subgoal.path[0]);
  }
}

sim::Action NtsAgent::Wander() {
  subgoal_.reset();
  target_ = navigator_.Frontier();
  if (target_) {
    if (const auto plan = navigator_.Plan(*target_, false)) return navigator_.Steer(plan->point);
  }
  target_.reset();
  navigator_.ForgetFeltWalls();
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
