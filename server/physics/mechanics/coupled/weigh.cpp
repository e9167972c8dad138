#include <algorithm>

#include "common/assert.h"
#include "server/physics/mechanics/coupled/island.h"

namespace prosector::coupled {
namespace {

bool is_met(const Island& island, const SoftMember& member) {
  const auto its = [&](const contact::ContactSide& side) {
    return side.kind == contact::ContactSide::Kind::soft && side.body == member.index;
  };
  const auto meets = [&](const auto& joint) { return its(joint.a) || its(joint.b); };
  return std::any_of(island.contacts.begin(), island.contacts.end(), meets) ||
         std::any_of(island.ties.begin(), island.ties.end(), meets);
}

}  // namespace

void weigh(Island& island, const Vec3& gravity) {
  for (SoftMember& member : island.soft) {
    PROSECTOR_ASSERT(member.body != nullptr);
    member.weight = member.body->weight(gravity, true);
    const bool matters = member.weight.by_shape != nullptr;  // no effect with linear elements
    if (matters && !member.body->attached() && !is_met(island, member))
      member.weight = member.body->weight(gravity, false);
  }
}

}  // namespace prosector::coupled
