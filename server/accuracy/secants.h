#pragma once
// Corrections to an approximate inverse Hessian from the steps taken so far (L-BFGS, Nocedal 1980). The
// projected Hessian is stiffer than the true one where tissue is compressed. There, each step of Newton's
// method alone reduces the error by only a fifth.

#include <cstddef>
#include <deque>
#include <functional>

#include "common/math.h"

namespace prosector {

class Secants {
 public:
  /// Stores a solver's step and the change of the gradient over it. A pair without positive curvature
  /// (step·change ≤ 0) is ignored.
  void remember(const VecX& step, const VecX& change);
  /// Returns the descent direction −B⁻¹·gradient, where B is the Hessian as corrected by the stored pairs
  /// (L-BFGS). `solve` returns H⁻¹r for the current approximate Hessian H, which is used for directions that
  /// no pair covers.
  VecX direction(const VecX& gradient, const std::function<VecX(const VecX& r)>& solve) const;

 private:
  struct Pair {
    VecX step, change;
    double curvature;  // step·change
  };
  std::deque<Pair> pairs_;  // oldest first
};

}  // namespace prosector
