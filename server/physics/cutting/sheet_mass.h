#pragma once
// Masses of a sheet's nodes where it is cut. Springs carry no volume to lump: a new node takes of the mass of
// its neighbours.

namespace prosector {

struct EdgeMasses {
  double a = 0, b = 0, node = 0;  // kg: of the ends, and of the new node between
};

/// An end that is held in its place counts as infinitely heavy.
struct EdgeEnd {
  double mass = 0;  // kg
  bool held = false;
};

/// Returns the edge's two masses shared with a node at a + t·(b − a). Both ends free, or both held (the node
/// is held then too): m = mₐ + t(m_b − mₐ), and all three times (mₐ + m_b)/(mₐ + m_b + m). One held: the
/// other's, half and half. Their sum stays.
EdgeMasses share_mass(const EdgeEnd& a, const EdgeEnd& b, double t);

}  // namespace prosector
