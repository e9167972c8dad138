#pragma once
// The data and the steps of an error estimate of one soft body (body_estimator.h). Private to
// server/accuracy.

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "server/accuracy/body_estimator.h"
#include "server/accuracy/bubbles.h"
#include "server/accuracy/law_difference.h"
#include "server/accuracy/outer_surface.h"
#include "server/physics/mechanics/soft/elements/tet10.h"

namespace prosector::estimation {

using Corners = std::array<std::uint32_t, 4>;
using Columns = Eigen::Matrix<double, 3, 4>;  // one column for each corner

/// Returns the index of a node's first coordinate in a vector of all nodes' coordinates.
inline Eigen::Index at(std::uint32_t node) {
  return 3 * static_cast<Eigen::Index>(node);
}

/// Index of the hierarchical functions: numbers edges and faces by their sorted corners.
class FunctionIndex {
 public:
  using Key = std::array<std::uint32_t, 3>;  // for an edge: its second corner twice
  static Key key(std::span<const std::size_t> corners, std::span<const std::uint32_t> nodes) {
    Key out{nodes[corners[0]], nodes[corners[1]], nodes[corners.back()]};
    std::sort(out.begin(), out.end());
    return out;
  }
  void add(const Key& key) { keys_.push_back(key); }
  void close() {
    std::sort(keys_.begin(), keys_.end());
    keys_.erase(std::unique(keys_.begin(), keys_.end()), keys_.end());
  }
  std::size_t size() const { return keys_.size(); }
  const Key& operator[](std::size_t k) const { return keys_[k]; }
  std::uint32_t find(const Key& key) const {
    return static_cast<std::uint32_t>(std::lower_bound(keys_.begin(), keys_.end(), key) - keys_.begin());
  }

 private:
  std::vector<Key> keys_;
};

/// The laws of one material, with its volumetric stiffness split between integration points and element mean.
struct MaterialLaws {
  std::unique_ptr<ConstitutiveLaw> own, tissue;  // tissue: null if it equals own
  Lame lame, local;
  double mean;  // Pa: λ'', the volumetric stiffness of an element's mean
};

/// Returns the matrix that extrapolates a linear field from the four integration points to the corners.
Eigen::Matrix4d corners_from_points();

/// The present state of an element.
struct ElementState {
  std::array<Mat3, 4> P;                    // Pa, at the corners
  Mat3 R = Mat3::Identity();                // rotation of its mean F
  Mat3 S = Mat3::Zero(), Q = Mat3::Zero();  // means of RᵀF and RᵀP
  double work = 0;                          // J/m³: P:(F − R)
  LawDifference law;                        // difference from tissue's law
};

/// An earlier state of a body, which is subtracted from later ones.
struct Baseline {
  std::vector<Mat3> S, Q;  // by element
  std::vector<LawDifference> law;
  std::vector<Vec3> residual;  // N, by function, in the world frame
  std::vector<Vec3> reaction;  // N, by vertex, in the world frame
  Mat3 turn = Mat3::Identity();
  bool known = false;
};

/// Sums over a body of what exceeds a baseline.
struct Sums {
  double work = 0;                  // J: 2W
  double surplus = 0;               // J: η²
  double law = 0;                   // J: work of the body's law beyond tissue's
  double squares = 0, fourths = 0;  // N², N⁴: powers of the forces that press outer vertices
  double weight = 0;                // N: forces that act on the volume
};

/// Data of a body whose errors are estimated, and the estimate that is being made. An estimate is divided
/// into pieces: one for each element, outer face and hierarchical function, and one that combines them.
struct ErrorWork {
  ErrorWork(const SoftDesc& desc, const TetMesh& mesh, const VecX& ties, const std::string& tissue);

  // ---- Constant data
  TetMesh mesh;
  bool quadratic;
  std::optional<Tet10Elements> tet10;
  Tet4Elements elements;  // by corner nodes
  BubbleTable table;
  Eigen::Matrix4d corners_of = corners_from_points();
  std::vector<MaterialLaws> laws;
  std::vector<std::uint32_t> kind;  // by element
  std::vector<double> space;        // m³, of each element at rest
  FunctionIndex functions;
  std::vector<std::uint32_t> function;  // by element and table.of_tet
  std::vector<std::uint32_t> owner;     // by function: the element whose rotation applies
  std::vector<Mat3> compliance;         // m/N, by function: K⁻¹ at rest
  std::vector<double> tie;              // N/m⁴, by vertex
  double density;
  std::vector<OuterFace> faces;
  std::vector<std::uint32_t> face_function;  // by face and table.of_face
  std::vector<double> area, volume;          // m² and m³ of each vertex
  double all_volume = 0;

  // ---- The current estimate
  BodyMoment moment;
  std::size_t done = 0;
  std::vector<Mat3> S, Q, R;        // by element
  std::vector<LawDifference> law;   // by element
  std::vector<Vec3> residual;       // N, by function
  std::vector<Vec3> reaction;       // N, by vertex: force of the stress that volume forces don't balance
  std::vector<double> disc, model;  // J, by vertex
  Mat3 mean_F = Mat3::Zero();
  Sums all, press;
  double slip = 0;  // J: twice the strain energy of moment.slip

  Baseline rest, quiet;
  Estimate newest;

  std::size_t element_count() const { return elements.size(); }
  std::size_t piece_count() const { return element_count() + faces.size() + functions.size() + 1; }

  void make_laws(const SoftDesc& desc, const std::string& tissue);
  void make_functions();
  void make_faces();
  void make_compliance();
  void clear();
  void piece(std::size_t k);
  Columns slopes(std::size_t e) const;
  void linear_state(std::size_t e, const VecX& x, ElementState& out) const;
  void quadratic_state(std::size_t e, const VecX& x, ElementState& out) const;
  void add_element(std::size_t e);
  void add_face(std::size_t f);
  void add_function(std::size_t k);
  double above(const Baseline& base, std::size_t k, const Vec3& r) const;
  void add_forces(const Baseline& base, Sums& sums) const;
  double surplus_share(const Sums& sums) const;
  void finish();
  void keep(Baseline& base) const;
};

}  // namespace prosector::estimation
