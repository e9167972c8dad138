#pragma once
// Node masses of a sheet that is cut. Springs have no volume to lump: a new node takes mass from its
// neighbours.

namespace prosector::cutting {

struct EdgeMasses {
  double a = 0, b = 0, node = 0;  // kg: of the ends, and of the new node between them
};

/// End of a sheet's edge to be split, with its mass. An end that is fixed in position (`held`) counts as
/// infinitely heavy.
struct EdgeEnd {
  double mass = 0;  // kg
  bool held = false;
};

/// Returns the masses of an edge's ends and of a new node inserted at a + t·(b − a). If both ends are free,
/// or both are held (then the new node is held, too), let m = mₐ + t(m_b − mₐ). The three masses are mₐ, m_b
/// and m, scaled by (mₐ + m_b)/(mₐ + m_b + m). If only one end is held, the free end gives half its mass to
/// the new node. The total mass is conserved.
EdgeMasses share_mass(const EdgeEnd& a, const EdgeEnd& b, double t);

}  // namespace prosector::cutting
