#pragma once
// Constant data of a soft body whose errors are estimated (body_estimator.h), and the stress in its elements.
// Private to server/accuracy.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "server/accuracy/body_estimator.h"
#include "server/accuracy/law_difference.h"
#include "server/physics/mechanics/soft/elements/tet10.h"

namespace prosector::estimation {

using Corners = std::array<std::uint32_t, 4>;
using Columns = Eigen::Matrix<double, 3, 4>;  // one column for each corner

/// Returns the index of a node's first coordinate in a vector of all nodes' coordinates.
inline Eigen::Index at(std::uint32_t node) {
  return 3 * static_cast<Eigen::Index>(node);
}

/// The laws of one material, with its volumetric stiffness split between integration points and element mean.
struct MaterialLaws {
  std::unique_ptr<soft::ConstitutiveLaw> own, tissue;  // tissue: null if it equals own
  soft::Lame lame, local;
  double mean;  // Pa: λ'', the volumetric stiffness of an element's mean
};

/// Returns the matrix that extrapolates a linear field from the four integration points to the corners.
Eigen::Matrix4d corners_from_points();

/// Force on the volume of an element, N/m³. It is linear over the element.
struct VolumeForce {
  std::array<Vec3, 4> at_corner;
  Vec3 sum = Vec3::Zero();  // of the corners' values
};

/// The present state of an element.
struct ElementState {
  std::array<Mat3, 4> P;                    // Pa, at the corners
  Mat3 mean_P;                              // Pa
  Mat3 R = Mat3::Identity();                // rotation of its mean F
  Mat3 S = Mat3::Zero(), Q = Mat3::Zero();  // means of RᵀF and RᵀP
  double work = 0;                          // J/m³: P:(F − R)
  LawDifference law;                        // difference from tissue's law
  VolumeForce force;
};

/// Constant data of a body whose errors are estimated: its elements, laws, volumes and attachments.
struct EstimatedBody {
  EstimatedBody(const SoftDesc& desc, const TetMesh& mesh, const VecX& ties, const std::string& tissue);

  TetMesh mesh;
  bool quadratic;
  std::optional<soft::Tet10Elements> tet10;
  soft::Tet4Elements elements;  // by corner nodes
  Eigen::Matrix4d corners_of = corners_from_points();
  std::vector<MaterialLaws> laws;
  std::vector<std::uint32_t> kind;  // by element
  std::vector<double> space;        // m³, of each element at rest
  std::vector<double> volume;       // m³, of each vertex
  double all_volume = 0;            // m³
  std::vector<double> tie;          // N/m⁴, by vertex
  double density;

  std::size_t element_count() const { return elements.size(); }
  std::size_t vertex_count() const { return volume.size(); }

  /// Returns the gradients of the corners' barycentric coordinates of element e at rest, 1/m.
  Columns slopes(std::size_t e) const;
  /// Returns the least attachment stiffness per volume (N/m per m³) at these corners (0 … 3) of element e.
  double least_tie(std::size_t e, std::span<const std::size_t> corners) const;
  /// Returns the stress of element e at the node positions of `moment`, and the force on its volume.
  ElementState state(std::size_t e, const BodyMoment& moment) const;

 private:
  void make_laws(const SoftDesc& desc, const std::string& tissue);
  void make_volumes();
  void make_ties(const VecX& ties);
  ElementState linear_state(std::size_t e, const VecX& x) const;
  ElementState quadratic_state(std::size_t e, const VecX& x) const;
  VolumeForce volume_force(std::size_t e, const VecX& acceleration) const;
};

}  // namespace prosector::estimation
