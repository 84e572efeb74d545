// SPDX-License-Identifier: MIT
#include "agent/slam/loops/hierarchy.h"
#include "agent/slam/loops/loop_registry.h"

namespace bulletnav::agent {
namespace {

/// The second paper's hierarchy, with sequences cut to five frames: what their own lengths are
/// worth. Source: Sharma et al., "Hierarchical Unsupervised Topological SLAM", 2023, section IV-C2.
class HutFixed5 final : public HierarchyDetector {
 public:
  static constexpr std::string_view kName = "hut_fixed5";
  struct Config : HierarchyConfig {
    Config() { length = 5; }
  };

  HutFixed5(const Config& config, const LoopContext& context)
      : HierarchyDetector(kName, config, context) {}
};

const LoopDetectorRegistration<HutFixed5> registration;

}  // namespace
}  // namespace bulletnav::agent
