#pragma once
// Simulated field similar to the sampled one, to test a fit: predicts a receiver's report at any position.
//
// The reported pose is truth + g, where g depends on the true position. The samples give noisy values of g.
// It is modelled as the spline with |r|³, which is smoother than the map's |r|. The noise level maximises the
// restricted likelihood (Wahba 1985; Kitanidis 1983). With the weights w and the scale σ² = yᵀw/(n − t), it
// minimises
//   (n − t) log σ² + log |det|
// over δ = noise²/σ². The search is bounded by the noise of a receiver that is held still. Known noise is
// used where it is larger.

#include <random>
#include <span>
#include <vector>

#include "drivers/fitting/field_sample.h"
#include "drivers/fitting/pose_errors.h"
#include "drivers/fitting/spline_system.h"

namespace prosector {

class SimulatedField {
 public:
  /// Fits a simulated distortion of the magnetic field to measured samples, whose true positions must fill a
  /// box. `noise` is the known RMS noise of each sample's reported pose.
  SimulatedField(std::span<const FieldSample> samples, const PoseErrors& noise);

  /// Returns the pose that a receiver at the pose `truth` reports in the simulated distorted field, without
  /// noise; m, tracker's frame.
  Pose report(const Pose& truth) const;
  /// Returns the measured samples with their reported poses replaced by simulated ones: those of this field
  /// at the same true poses, plus random noise.
  std::vector<FieldSample> again(std::mt19937_64& random) const;
  /// Returns `count` samples with random true positions, without rotation, in the box of the measured ones,
  /// and the poses that this field reports there without noise.
  std::vector<FieldSample> anywhere(std::mt19937_64& random, std::size_t count) const;

 private:
  /// The most likely spline found so far for three of the six values that describe the simulated distortion:
  /// the position offset, or the vector part of the rotation's quaternion.
  struct Part {
    double most_noise;         // RMS of each value: upper bound of the search
    double noise = 0;          // RMS of each value: the most likely one
    double criterion = 0;      // (n − t) log σ² + log |det|, to be minimised
    Eigen::MatrixXd solution;  // weights, then polynomial coefficients
  };
  void consider(const SplineSolution& spline, const Eigen::MatrixXd& values, Eigen::Index first, double share,
                Part& best) const;
  Vec3 scaled(const Vec3& place) const { return (place - centre_).cwiseQuotient(half_); }

  Vec3 centre_, half_;  // m, box of the true positions
  std::vector<Pose> truths_;
  std::vector<Vec3> nodes_;      // in units of the box
  Eigen::MatrixXd polynomials_;  // values of the polynomials at the nodes
  Eigen::MatrixXd solution_;  // weights, then polynomial coefficients, for the offset (m) and the vector part
                              // of a quaternion
  PoseErrors
      noise_;  // RMS of each component: position, m; vector part of the quaternion, half the angle in rad
};

}  // namespace prosector
