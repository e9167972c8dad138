#pragma once
// First stage of an error estimate: the stress of a body in one state, and the forces that it does not
// balance. Private to server/accuracy.

#include <vector>

#include "server/accuracy/missing_functions.h"

namespace prosector::estimation {

/// An earlier state of a body, which is subtracted from later ones.
struct Baseline {
  std::vector<Mat3> S, Q;  // by element
  std::vector<LawDifference> law;
  std::vector<Vec3> residual;  // N, by function, in the world frame
  std::vector<Vec3> reaction;  // N, by vertex, in the world frame
  Mat3 turn = Mat3::Identity();
  bool known = false;
};

/// The earlier states of a body that an estimate subtracts.
struct Baselines {
  Baseline rest;   // of tissue under tension; else unknown: no stress at rest
  Baseline quiet;  // before the press

  /// Returns the body's state before hands or other bodies pressed it, which an estimate subtracts.
  const Baseline& before_press() const { return quiet.known ? quiet : rest; }
};

/// Stress and strain of a body in one state, and the forces that the stress does not balance. The elements
/// are added first, then the outer faces.
struct StressState {
  StressState(const EstimatedBody& body, const MissingFunctions& functions);

  std::vector<Mat3> S, Q, R;       // by element
  std::vector<LawDifference> law;  // by element
  std::vector<Vec3> residual;      // N, by function
  std::vector<Vec3> reaction;      // N, by vertex: force of the stress that volume forces don't balance
  Mat3 mean_F = Mat3::Zero();      // times the body's volume

  void clear();
  /// Adds the stress `now` of element e and its residuals. `x` is the positions of the body's nodes (3n, m).
  void add_element(const EstimatedBody& body, const MissingFunctions& functions, std::size_t e,
                   const ElementState& now, const VecX& x);
  /// Treats the unbalanced forces at a face's vertices as a surface traction that is linear over the face.
  void add_face(const EstimatedBody& body, const MissingFunctions& functions, std::size_t f);

  /// Returns r·K⁻¹·r of function k, J, with the residual r that exceeds a baseline.
  double energy_above(const MissingFunctions& functions, const Baseline& base, std::size_t k) const;
  void keep(Baseline& base) const;
};

}  // namespace prosector::estimation
