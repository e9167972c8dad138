#pragma once
// Correction of tracker poses in a magnetic field that metal distorts.
//
// The reported position is scaled to the cube ±1: x = (p − centre)/half. The correction is
//
//   y(x) = Σ_j a_j T_j(x) + Σ_i w_i |x − x_i|
//
// T_j are products of Chebyshev polynomials up to a total degree. The second sum is a spline: |r| is the
// Green's function of the biharmonic equation in space, which minimises the bending energy of the interpolant
// (Duchon 1977). Without nodes x_i the map is a polynomial.
//
// y has seven components: the position offset in metres, then a quaternion. The quaternion is normalised and
// multiplies the orientation from the left (Ikits, Brederson, Hansen and Hollerbach 2001; survey: Kindratenko
// 2000). Frame: the device's, x right, y up, −z forward. Positions outside the sampled box are clamped to it.

#include <filesystem>
#include <string>
#include <vector>

#include "common/math.h"

namespace prosector {

inline constexpr int most_field_degree = 8;
inline constexpr std::size_t most_field_nodes = 4096;

using FieldTerms = Eigen::Matrix<double, Eigen::Dynamic, 7>;  // x y z (m), w x y z

struct FieldMap {
  Vec3 centre = Vec3::Zero(), half = Vec3::Ones();  // m, centre and half extents of the sampled box
  int degree = 0;                                   // total degree of the polynomial
  FieldTerms polynomial;                            // a_j
  std::vector<Vec3> nodes;                          // x_i, scaled
  FieldTerms weights;                               // w_i
  double before = 0, after = 0;                     // m RMS: error at the sampled points without the map, and
                                                    // expected error between them with it

  /// Scales a position (m, device frame) so that the box sampled for the map becomes the cube −1 … 1. Clamps
  /// positions outside the box to its surface.
  Vec3 scaled(const Vec3& place) const;
  /// Corrects a pose reported by the tracker (m, device frame) for the distortion of the magnetic field.
  /// Returns the corrected pose in the device frame.
  Pose apply(const Pose& reported) const;
};

/// Returns the number of products of Chebyshev polynomials in x, y and z whose total degree is at most
/// `degree`.
std::size_t field_term_count(int degree);
/// Evaluates all products of Chebyshev polynomials in x, y and z up to a total degree at a position scaled to
/// −1 … 1. Returns one value per product.
VecX field_terms(const Vec3& scaled, int degree);

/// Parses the TOML text of a map that corrects a tracker for magnetic distortion. `file` names the file in
/// messages. Throws InputError with file, line, key and the allowed values.
FieldMap parse_field_map(const std::string& toml, const std::string& file);
FieldMap load_field_map(const std::filesystem::path& file);
std::string write_field_map(const FieldMap& map);

}  // namespace prosector
