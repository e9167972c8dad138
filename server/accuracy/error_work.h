#pragma once
// An error estimate of one soft body (body_estimator.h), divided into pieces of work. Private to
// server/accuracy.

#include <string>

#include "server/accuracy/error_sums.h"

namespace prosector::estimation {

/// A body whose errors are estimated, and the estimate that is being made. An estimate is divided into
/// pieces: one for each element, outer face and hierarchical function, and one that combines them.
struct ErrorWork {
  ErrorWork(const SoftDesc& desc, const TetMesh& mesh, const VecX& ties, const std::string& tissue);

  EstimatedBody body;
  MissingFunctions functions;
  BodyMoment moment;
  std::size_t done = 0;  // pieces of the current estimate
  StressState state;
  ErrorSums sums;
  Baselines before;
  Estimate newest;

  std::size_t piece_count() const {
    return body.element_count() + functions.faces.size() + functions.size() + 1;
  }
  void clear();
  void piece(std::size_t k);

 private:
  void estimate_rest();
  void add_element(std::size_t e);
  void add_function(std::size_t k);
};

}  // namespace prosector::estimation
