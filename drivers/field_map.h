#pragma once
// How a magnetic field that metal bends makes a tracker's poses wrong, and how they are put right.
//
// The place that a receiver reports is scaled to the cube ±1: x = (p − centre)/half. What is added there is
//
//   y(x) = Σ_j a_j T_j(x) + Σ_i w_i |x − x_i|
//
// T_j are products of Chebyshev polynomials up to a total degree. The second sum is a spline: |r| is the
// Green's function of the biharmonic equation in space, so it bends least of all that fit (Duchon 1977).
// Without nodes x_i the map is a polynomial.
//
// y has seven numbers: the shift of the position in metres, then a quaternion. It is normalised and
// multiplies the orientation from the left (Ikits, Brederson, Hansen and Hollerbach 2001; survey: Kindratenko
// 2000). Frame: the device's, x right, y up, −z forward. Beyond the sampled box the correction is that of its
// nearest place.

#include <filesystem>
#include <string>
#include <vector>

#include "common/math.h"

namespace prosector {

inline constexpr int most_field_degree = 8;
inline constexpr std::size_t most_field_nodes = 4096;

using FieldTerms = Eigen::Matrix<double, Eigen::Dynamic, 7>;  // x y z (m), w x y z

struct FieldMap {
  Vec3 centre = Vec3::Zero(), half = Vec3::Ones();  // m, of the sampled box
  int degree = 0;                                   // of the polynomial, total
  FieldTerms polynomial;                            // a_j
  std::vector<Vec3> nodes;                          // x_i, scaled
  FieldTerms weights;                               // w_i
  double before = 0, after = 0;                     // m RMS at the sampled points, and to expect between them

  /// Returns the place scaled to ±1, beyond the box its nearest place.
  Vec3 scaled(const Vec3& place) const;
  /// Returns the pose put right.
  Pose apply(const Pose& reported) const;
};

/// Returns how many polynomials there are up to a total degree.
std::size_t field_term_count(int degree);
/// Returns the polynomials' values at a scaled place.
VecX field_terms(const Vec3& scaled, int degree);

/// Reads a map. Throws InputError with file, line, key and what is allowed.
FieldMap parse_field_map(const std::string& toml, const std::string& file);
FieldMap load_field_map(const std::filesystem::path& file);
std::string write_field_map(const FieldMap& map);

}  // namespace prosector
