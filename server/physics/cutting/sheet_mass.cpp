#include "server/physics/cutting/sheet_mass.h"

#include "server/physics/cutting/tet_complex.h"

namespace prosector {

EdgeMasses share_mass(const EdgeEnd& a, const EdgeEnd& b, double t) {
  if (a.held != b.held)
    return a.held ? EdgeMasses{a.mass, b.mass / 2, b.mass / 2} : EdgeMasses{a.mass / 2, b.mass, a.mass / 2};
  const double sum = a.mass + b.mass, m = a.mass + t * (b.mass - a.mass), f = sum / (sum + m);
  return {f * a.mass, f * b.mass, f * m};
}

void TetComplex::share_mass(const SplitEdge& op) {
  const bool at_a = is_held(op.a), at_b = is_held(op.b);
  shared_.resize(node_end());
  shared_[op.node] = {mass_[op.a], mass_[op.b]};
  const EdgeMasses now = prosector::share_mass({mass_[op.a], at_a}, {mass_[op.b], at_b}, op.t);
  mass_[op.a] = now.a;
  mass_[op.b] = now.b;
  mass_[op.node] = now.node;
  held_[op.node] = at_a && at_b;
}

/// By the areas that go with each copy.
void TetComplex::share_mass(const PartNode& op) {
  const auto area = [&](NodeId node) {
    double sum = 0;
    for (const TetId t : star_[node]) sum += tet_[t].volume;
    return sum;
  };
  const double whole = mass_[op.node];
  double sum = area(op.node);
  for (const auto& copy : op.copies) sum += area(copy.node);
  shared_.resize(node_end());
  shared_[op.copies.front().node] = {whole, 0};
  for (const auto& copy : op.copies) {
    mass_[copy.node] = whole * area(copy.node) / sum;
    held_[copy.node] = held_[op.node];
  }
  mass_[op.node] = whole * area(op.node) / sum;
}

void TetComplex::share_back(const SplitEdge& op) {
  mass_[op.a] = shared_[op.node].a;
  mass_[op.b] = shared_[op.node].b;
}

void TetComplex::share_back(const PartNode& op) {
  mass_[op.node] = shared_[op.copies.front().node].a;
}

}  // namespace prosector
