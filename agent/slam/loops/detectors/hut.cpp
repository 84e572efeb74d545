// SPDX-License-Identifier: MIT
#include "agent/slam/loops/hierarchy.h"
#include "agent/slam/loops/loop_registry.h"

namespace bulletnav::agent {
namespace {

/// The second paper's hierarchy on learned descriptors, with sequences as long as they come; see
/// HierarchyDetector.
class Hut final : public HierarchyDetector {
 public:
  static constexpr std::string_view kName = "hut";
  using Config = HierarchyConfig;

  Hut(const Config& config, const LoopContext& context)
      : HierarchyDetector(kName, config, context) {}
};

const LoopDetectorRegistration<Hut> registration;

}  // namespace
}  // namespace bulletnav::agent
