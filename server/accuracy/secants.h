#pragma once
// What steps taken told about the Hessian: corrections to an approximate inverse (L-BFGS, Nocedal 1980). The
// projected Hessian is stiffer than the true one where tissue is compressed, so that Newton's method by
// itself converges by a fifth a step there.

#include <cstddef>
#include <deque>
#include <functional>

#include "common/math.h"

namespace prosector {

class Secants {
 public:
  /// Remembers that a step changed the gradient so. Pairs without positive curvature are passed over.
  void remember(const VecX& step, const VecX& change);
  /// Returns the descent direction −B⁻¹·gradient, where `solve` finds H⁻¹r for the Hessian at hand, which
  /// stands for what no pair tells.
  VecX direction(const VecX& gradient, const std::function<VecX(const VecX& r)>& solve) const;

 private:
  struct Pair {
    VecX step, change;
    double curvature;  // step·change
  };
  std::deque<Pair> pairs_;  // oldest first
};

}  // namespace prosector
