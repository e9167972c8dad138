#pragma once
// Second stage of an error estimate: sums of works and forces beyond a baseline, and the relative errors that
// follow from them. Private to server/accuracy.

#include <vector>

#include "server/accuracy/stress_state.h"

namespace prosector::estimation {

/// Sums over a body of what exceeds a baseline.
struct Sums {
  double work = 0;                  // J: 2W
  double surplus = 0;               // J: η²
  double law = 0;                   // J: work of the body's law beyond tissue's
  double squares = 0, fourths = 0;  // N², N⁴: powers of the forces that press outer vertices
  double weight = 0;                // N: forces that act on the volume
};

/// The sums of an estimate for all loads and for the press, and how the errors are distributed.
struct ErrorSums {
  explicit ErrorSums(std::size_t vertices);

  Sums all, press;
  double slip = 0;                  // J: twice the strain energy of BodyMoment::slip
  std::vector<double> disc, model;  // J, by vertex

  void clear();
  /// Adds the works of element e in the state `now`. `slip` is BodyMoment::slip.
  void add_element(const EstimatedBody& body, std::size_t e, const ElementState& now, const Baselines& before,
                   const VecX& slip);
  /// Adds energies (J) of a shape function that the elements lack: beyond rest, and beyond before a press.
  void add_function(const FunctionIndex::Key& corners, double of_all, double of_press);
  /// Adds the forces on outer vertices, after all elements were added.
  void add_forces(const EstimatedBody& body, const MissingFunctions& functions, const StressState& state,
                  const Baselines& before);
  /// Computes the relative errors, after all sums are complete.
  void estimate(const EstimatedBody& body, const BodyMoment& moment, Estimate& out) const;

 private:
  void add_law_work(const EstimatedBody& body, std::size_t e, const ElementState& now, const Baseline& rest);
  void distribute(double d, double m, const EstimatedBody& body, Estimate& out) const;
};

}  // namespace prosector::estimation
