#pragma once
// A field like the one that samples show, to try a fit on: what a receiver would report at any place.
//
// Over the true places, what is reported is truth + g. Of g the samples tell values with noise. g is taken as
// the spline with |r|³, which is smoother than the map's |r|. How much noise there is says the greatest
// restricted likelihood (Wahba 1985; Kitanidis 1983): with the weights w and the scale σ² = yᵀw/(n − t), the
// least of
//   (n − t) log σ² + log |det|
// over δ = noise²/σ². It is searched below what a receiver that is held still tells. Noise that is known is
// put in where that is more.

#include <random>
#include <span>
#include <vector>

#include "drivers/fitting/field_sample.h"
#include "drivers/fitting/pose_errors.h"
#include "drivers/fitting/spline_system.h"

namespace prosector {

class LikeField {
 public:
  /// Takes samples that fill a box. `noise`: of each, as far as it is known.
  LikeField(std::span<const FieldSample> samples, const PoseErrors& noise);

  /// Returns what a receiver reports there, without noise.
  Pose report(const Pose& truth) const;
  /// Returns the samples as this field would give them, with new noise.
  std::vector<FieldSample> again(std::mt19937_64& random) const;
  /// Returns `count` poses anywhere in the box of the true places, and what is reported of them.
  std::vector<FieldSample> anywhere(std::mt19937_64& random, std::size_t count) const;

 private:
  /// The likeliest spline so far of three numbers over the box.
  struct Part {
    double most_noise;         // that is looked for, RMS of each number
    double noise = 0;          // the same, found
    double unlikely = 0;       // by which the likeliest is chosen
    Eigen::MatrixXd solution;  // weights, then the polynomial's
  };
  void consider(const SplineSolution& spline, const Eigen::MatrixXd& values, Eigen::Index first, double share,
                Part& best) const;
  Vec3 scaled(const Vec3& place) const { return (place - centre_).cwiseQuotient(half_); }

  Vec3 centre_, half_;  // m, of the true places
  std::vector<Pose> truths_;
  std::vector<Vec3> nodes_;      // scaled
  Eigen::MatrixXd polynomials_;  // at the nodes
  Eigen::MatrixXd solution_;     // weights, then the polynomial's: of the shift (m) and a quaternion's vector
  PoseErrors noise_;             // of each of three numbers: m, half a rad
};

}  // namespace prosector
