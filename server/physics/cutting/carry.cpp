#include "server/physics/cutting/carry.h"

#include <algorithm>

namespace prosector {
namespace {

struct Carry {
  std::vector<Vec3>& values;
  void set(NodeId node, const Vec3& value) const {
    if (node >= values.size()) values.resize(node + 1u, Vec3::Zero());
    values[node] = value;
  }
  void operator()(const SplitEdge& op) const {
    set(op.node, values[op.a] + (values[op.b] - values[op.a]) * op.t);
  }
  void operator()(const SlitFaces&) const {}
  void operator()(const PartNode& op) const {
    const Vec3 value = values[op.node];
    for (const auto& copy : op.copies) set(copy.node, value);
  }
};

struct CarryBack {
  const TetComplex& complex;
  std::vector<Vec3>&positions, &velocities;

  void operator()(const SplitEdge& op) const {
    const double mass = complex.mass(op.node);
    for (const auto& [end, share] : {std::pair{op.a, 1 - op.t}, std::pair{op.b, op.t}}) {
      const double own = complex.mass(end), given = share * mass;
      velocities[end] = (own * velocities[end] + given * velocities[op.node]) / (own + given);
    }
  }
  void operator()(const SlitFaces&) const {}
  void operator()(const PartNode& op) const {
    double mass = complex.mass(op.node);
    Vec3 first = mass * positions[op.node], momentum = mass * velocities[op.node];
    for (const auto& copy : op.copies) {
      const double m = complex.mass(copy.node);
      mass += m;
      first += m * positions[copy.node];
      momentum += m * velocities[copy.node];
    }
    positions[op.node] = first / mass;
    velocities[op.node] = momentum / mass;
  }
};

}  // namespace

void carry(const TopologyOp& op, std::vector<Vec3>& values) {
  std::visit(Carry{values}, op);
}

void carry_back(const TopologyOp& op, const TetComplex& complex, std::vector<Vec3>& positions,
                std::vector<Vec3>& velocities) {
  std::visit(CarryBack{complex, positions, velocities}, op);
}

}  // namespace prosector
