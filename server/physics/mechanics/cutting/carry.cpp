#include "server/physics/mechanics/cutting/carry.h"

#include <algorithm>

#include "common/assert.h"

namespace prosector::cutting {
namespace {

struct Carry {
  std::vector<Vec3>& values;
  void set(NodeId node, const Vec3& value) const {
    if (node >= values.size()) values.resize(node + 1u, Vec3::Zero());
    values[node] = value;
  }
  void operator()(const SplitEdge& op) const {
    PROSECTOR_ASSERT(op.a < values.size() && op.b < values.size());
    set(op.node, values[op.a] + (values[op.b] - values[op.a]) * op.t);
  }
  void operator()(const SlitFaces&) const {}
  void operator()(const PartNode& op) const {
    PROSECTOR_ASSERT(op.node < values.size());
    const Vec3 value = values[op.node];
    for (const auto& copy : op.copies) set(copy.node, value);
  }
};

}  // namespace

void carry(const TopologyOp& op, std::vector<Vec3>& values) {
  std::visit(Carry{values}, op);
}

}  // namespace prosector::cutting
