// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>

#include "agent/mapping/map_navigator.h"
#include "agent/mapping/progress_watch.h"
#include "agent/models/usual_slots.h"
#include "agent/nts/topological_graph.h"
#include "agent/perception/relative_pose.h"
#include "agent/registry.h"
#include "sim/base/error.h"
#include "sim/math/rng.h"

namespace bulletnav::agent {
namespace {

/// Neural Topological SLAM by the rules of section 4.1 alone, so that what `nts` adds to them can
/// be measured. What the text leaves open and had to be settled, or the body would stand still: the
/// last node is kept as long as F_L knows the body there; a ghost node or the next node counts as
/// reached `reached` metres from it, and a reached ghost becomes a node; a ghost that does not come
/// nearer for `patience` steps is removed; with no ghost left the present view becomes a node, and
/// if that has none either, the body walks at random.
class NtsPaper final : public Agent {
 public:
  static constexpr std::string_view kName = "nts_paper";

  /// The paper names none of these; chosen on the validation houses (docs/agents_results.md).
  struct Config {
    NavigatorSpec navigator;
    double same_node = 0.8;      // probability from which an observation belongs to a node
    double explorable = 0.3;     // probability from which a direction gets a ghost node
    double goal_seen = 0.5;      // probability from which the goal belongs to a node
    double stop_distance = 0.5;  // metres to the goal, by F_R
    double reached = 0.75;       // metres
    int patience = 15;           // steps

    template <class V>
    void Visit(V& v) {
      v("navigator", navigator);
      v("same_node", same_node);
      v("explorable", explorable);
      v("goal_seen", goal_seen);
      v("stop_distance", stop_distance);
      v("reached", reached);
      v("patience", patience);
    }
    void Validate() const {
      for (const double probability : {same_node, explorable, goal_seen}) {
        if (probability > 0.0 && probability < 1.0) continue;
        throw sim::Error("same_node, explorable and goal_seen must lie between 0 and 1");
      }
      if (!(stop_distance > 0.0 && reached > 0.0)) {
        throw sim::Error("stop_distance and reached must be positive");
      }
      if (patience < 1) throw sim::Error("patience must be at least 1");
    }
  };

  static std::vector<ModelSlot> ModelSlots(const Rig& rig) { return SemanticAndMapSlots(rig); }

  NtsPaper(const Config& config, const AgentContext& context)
      : config_(config),
        model_(context.models.Need<SemanticModel>(kSemanticModel)),
        navigator_(context.rig, config.navigator, context.models.Find<FreeSpaceModel>(kMapper)),
        watch_(config.patience, kLeastProgress) {}

  void Reset(const Panorama& goal, std::uint64_t seed) override {
    navigator_.Reset();
    graph_.Clear();
    current_ = -1;
    NextGoal(goal, seed);
  }

  void NextGoal(const Panorama& goal, std::uint64_t seed) override {
    goal_ = model_->Encode({&goal, 1}).front();
    views_.clear();
    watch_.Reset();
    rng_ = sim::Rng(seed, kName);
    has_stopped_ = false;
  }

  sim::Action Act(const Observation& observation) override {
    navigator_.Observe(observation);
    const PanoramaCode code = model_->Encode({&observation.panorama, 1}).front();
    UpdateGraph(code);
    const sim::Action action = Decide(code);
    navigator_.Took(action);
    return action;
  }

  Belief belief() const override {
    Belief belief{navigator_.pose(), std::nullopt, navigator_.map().Picture()};
    if (target_) belief.target = sim::PlanarPose{target_->x, target_->y, 0.0};
    belief.graph = graph_.Picture();
    return belief;
  }

 private:
  static constexpr double kLeastProgress = 0.25;  // metres that count as coming nearer

  // ---- Graph Update

  void UpdateGraph(const PanoramaCode& code) {
    const int node = Localise(code);
    if (node < 0) {
      AddNode(code);
    } else if (node != current_) {
      MoveTo(node);
    }
  }

  /// The last node as long as F_L knows the body there, else the one that it gives the highest
  /// probability; -1 if none has enough.
  int Localise(const PanoramaCode& code) const {
    std::vector<const PanoramaCode*> nodes;
    for (const RegularNode& node : graph_.nodes()) nodes.push_back(&node.code);
    if (nodes.empty()) return -1;
    const std::vector<PairPrediction> views = model_->Compare(nodes, code);
    const auto last = static_cast<std::size_t>(current_);
    if (views[last].same_node >= config_.same_node) return current_;
    return Likeliest(views, config_.same_node);
  }

  static int Likeliest(std::span<const PairPrediction> views, double least) {
    int best = -1;
    for (std::size_t i = 0; i < views.size(); ++i) {
      if (views[i].same_node < least) continue;
      const bool is_better =
          best < 0 || views[i].same_node > views[static_cast<std::size_t>(best)].same_node;
      if (is_better) best = static_cast<int>(i);
    }
    return best;
  }

  void AddNode(const PanoramaCode& code) {
    const int node = graph_.AddNode({code, navigator_.pose()});
    if (current_ >= 0) Join(current_, node);
    const std::array<float, kDirections> explorable = model_->Explorable(code);
    for (int i = 0; i < kDirections; ++i) {
      const bool is_open = explorable[static_cast<std::size_t>(i)] >= config_.explorable;
      if (is_open && !HasNodeIn(node, i)) graph_.AddGhost(node, i);
    }
    current_ = node;
  }

  void MoveTo(int node) {
    if (!graph_.HasEdge(current_, node)) Join(current_, node);
    current_ = node;
  }

  /// A node takes the place of ghosts of the other in its direction.
  void Join(int a, int b) {
    graph_.AddEdge(a, b);
    const std::vector<GhostNode> ghosts = graph_.ghosts();
    for (const GhostNode& ghost : ghosts) {
      const bool is_beside = (ghost.owner == a && DirectionTo(a, b) == ghost.direction) ||
                             (ghost.owner == b && DirectionTo(b, a) == ghost.direction);
      if (is_beside) graph_.RemoveGhost(ghost.id);
    }
  }

  int DirectionTo(int from, int to) const {
    return DirectionOf(graph_.BearingFrom(from, graph_.NodePoint(to)));
  }

  bool HasNodeIn(int node, int direction) const {
    return std::any_of(graph_.edges().begin(), graph_.edges().end(), [&](const GraphEdge& edge) {
      if (edge.a != node && edge.b != node) return false;
      return DirectionTo(node, edge.a == node ? edge.b : edge.a) == direction;
    });
  }

  // ---- Global Policy

  /// Compares nodes that are new with the goal.
  void ReadGoal() {
    std::vector<const PanoramaCode*> nodes;
    for (std::size_t i = views_.size(); i < graph_.nodes().size(); ++i) {
      nodes.push_back(&graph_.nodes()[i].code);
    }
    if (nodes.empty()) return;
    for (const PairPrediction& view : model_->Compare(nodes, goal_)) views_.push_back(view);
    const std::vector<GhostNode> ghosts = graph_.ghosts();
    for (const GhostNode& ghost : ghosts) {
      const PairPrediction& view = views_[static_cast<std::size_t>(ghost.owner)];
      graph_.SetScore(ghost.id, view.score[static_cast<std::size_t>(ghost.direction)]);
    }
  }

  const GhostNode* BestGhost() const {
    const GhostNode* best = nullptr;
    for (const GhostNode& ghost : graph_.ghosts()) {
      if (best == nullptr || ghost.score > best->score) best = &ghost;
    }
    return best;
  }

  /// The node after the present one on the shortest way to another.
  int NextOnTheWayTo(int node) const {
    const std::array<std::pair<int, double>, 1> start = {{{current_, 0.0}}};
    return graph_.Routes(start).To(node).at(1);
  }

  sim::Action Decide(const PanoramaCode& code) {
    bool is_anew = false;  // a node was made for its ghosts
    for (;;) {
      ReadGoal();
      const int with_goal = Likeliest(views_, config_.goal_seen);
      const GhostNode* ghost = with_goal < 0 ? BestGhost() : nullptr;
      if (with_goal < 0 && ghost == nullptr) {
        if (is_anew) return WalkAtRandom();
        AddNode(code);
        is_anew = true;
        continue;
      }
      const int node = ghost == nullptr ? with_goal : ghost->owner;
      if (node != current_) {
        const int next = NextOnTheWayTo(node);
        if (!IsReached(graph_.NodePoint(next))) return WalkTo(graph_.NodePoint(next));
        current_ = next;
      } else if (ghost == nullptr) {
        return ToGoal(code);
      } else if (IsReached(graph_.GhostPoint(*ghost))) {
        graph_.RemoveGhost(ghost->id);
        AddNode(code);
      } else if (watch_.IsStuck(ghost->id,
                                Distance(graph_.GhostPoint(*ghost), navigator_.here()))) {
        graph_.RemoveGhost(ghost->id);
      } else {
        return WalkTo(graph_.GhostPoint(*ghost));
      }
    }
  }

  bool IsReached(const Point& point) const {
    return Distance(point, navigator_.here()) <= config_.reached;
  }

  /// By F_R from the present observation. A stop that does not end the episode (condition no_stop)
  /// is not made again.
  sim::Action ToGoal(const PanoramaCode& code) {
    const std::array<const PanoramaCode*, 1> here = {&code};
    const RelativeGoal goal = RelativePoseOf(model_->Compare(here, goal_).front());
    if (goal.distance <= config_.stop_distance && !has_stopped_) {
      has_stopped_ = true;
      return sim::Action::kStop;
    }
    return WalkTo(navigator_.PointAt(goal.distance, goal.bearing));
  }

  // ---- Local Policy

  sim::Action WalkTo(const Point& point) {
    target_ = point;
    if (const auto plan = navigator_.Plan(point, true)) return navigator_.Steer(plan->point);
    navigator_.ForgetMap();
    return WalkAtRandom();
  }

  sim::Action WalkAtRandom() {
    return rng_.Chance(0.5) ? sim::Action::kMoveForward : sim::Action::kTurnLeft;
  }

  Config config_;
  std::shared_ptr<SemanticModel> model_;
  MapNavigator navigator_;
  ProgressWatch watch_;
  TopologicalGraph graph_;
  int current_ = -1;
  PanoramaCode goal_;
  std::vector<PairPrediction> views_;  // of the goal, by node
  sim::Rng rng_{0, kName};
  std::optional<Point> target_;
  bool has_stopped_ = false;
};

const AgentRegistration<NtsPaper> registration;

}  // namespace
}  // namespace bulletnav::agent
