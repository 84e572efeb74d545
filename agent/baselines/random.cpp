// SPDX-License-Identifier: MIT
#include "agent/registry.h"
#include "sim/base/error.h"
#include "sim/math/rng.h"

namespace bulletnav::agent {
namespace {

/// Draws every action: the floor of any table.
class RandomAgent final : public Agent {
 public:
  static constexpr std::string_view kName = "random";

  struct Config {
    double forward = 0.6;  // probabilities; turns share what is left
    double stop = 0.01;

    template <class V>
    void Visit(V& v) {
      v("forward", forward);
      v("stop", stop);
    }
    void Validate() const {
      if (forward < 0.0 || stop < 0.0 || forward + stop > 1.0) {
        throw sim::Error("forward and stop must be probabilities with a sum of at most 1");
      }
    }
  };

  RandomAgent(const Config& config, const AgentContext& /*context*/) : config_(config) {}

  void Reset(const Panorama& /*goal*/, std::uint64_t seed) override {
    rng_ = sim::Rng(seed, kName);
  }

  sim::Action Act(const Observation& /*observation*/) override {
    const double draw = rng_.Uniform();
    if (draw < config_.stop) return sim::Action::kStop;
    if (draw < config_.stop + config_.forward) return sim::Action::kMoveForward;
    return rng_.Chance(0.5) ? sim::Action::kTurnLeft : sim::Action::kTurnRight;
  }

 private:
  Config config_;
  sim::Rng rng_{0, kName};
};

const AgentRegistration<RandomAgent> registration;

}  // namespace
}  // namespace bulletnav::agent
