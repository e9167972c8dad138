#pragma once
// Node masses of a sheet that is cut. Springs have no volume to lump: a new node takes mass from its
// neighbours.

namespace prosector {

struct EdgeMasses {
  double a = 0, b = 0, node = 0;  // kg: of the ends, and of the new node between them
};

/// End of an edge. An end that is fixed in position counts as infinitely heavy.
struct EdgeEnd {
  double mass = 0;  // kg
  bool held = false;
};

/// Returns the masses after a node is inserted at a + t·(b − a). If both ends are free, or both held (then
/// the node is held too): m = mₐ + t(m_b − mₐ), and all three masses are scaled by (mₐ + m_b)/(mₐ + m_b + m).
/// If one end is held, the free end gives half its mass. The total mass is conserved.
EdgeMasses share_mass(const EdgeEnd& a, const EdgeEnd& b, double t);

}  // namespace prosector
