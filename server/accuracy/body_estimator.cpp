#include "server/accuracy/body_estimator.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <span>

#include "server/accuracy/bubbles.h"
#include "server/accuracy/law_difference.h"
#include "server/accuracy/outer_surface.h"
#include "server/physics/mechanics/soft/elements/tet10.h"
#include "server/physics/mechanics/soft/laws/mean_dilatation.h"
#include "server/physics/mechanics/soft/laws/polar.h"

namespace prosector {
namespace {

using Corners = std::array<std::uint32_t, 4>;
using Columns = Eigen::Matrix<double, 3, 4>;  // one column for each corner

/// Calibration of the error indicator: true squared error divided by η², fitted with `prosector-bench
/// estimate`.
struct Surplus {
  double even;          // factor for evenly distributed loads
  double concentrated;  // number of loaded vertices at which the factor doubles
};
constexpr Surplus linear_surplus = {1, 4.5}, quadratic_surplus = {0.6, 10};
constexpr double doubt = 0.2;  // relative uncertainty of a part, where two parts cancel
constexpr double negligible_strain = 1e-5;
constexpr double max_reported_error = 1e3;  // largest error reported, also for one that is not a number

std::size_t vertex_count(const TetMesh& mesh) {
  std::uint32_t last = 0;
  for (const Corners& tet : mesh.tets) last = std::max(last, *std::max_element(tet.begin(), tet.end()));
  return mesh.tets.empty() ? 0 : last + 1;
}

Eigen::Index at(std::uint32_t node) {
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
Eigen::Matrix4d corners_from_points() {
  const double at_corner = (5 + 3 * std::sqrt(5.)) / 20, elsewhere = (5 - std::sqrt(5.)) / 20;
  Eigen::Matrix4d points = Eigen::Matrix4d::Constant(elsewhere);
  points.diagonal().setConstant(at_corner);
  return points.inverse();
}

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

double finite(double error) {
  return std::isfinite(error) ? std::clamp(error, -max_reported_error, max_reported_error)
                              : max_reported_error;
}

}  // namespace

struct BodyEstimator::Work {
  Work(const SoftDesc& desc, const TetMesh& mesh, const VecX& ties, const std::string& tissue);

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
  ElementState state_of(std::size_t e, const VecX& x) const;
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

BodyEstimator::Work::Work(const SoftDesc& desc, const TetMesh& body_mesh, const VecX& ties,
                          const std::string& tissue)
    : mesh(body_mesh),
      quadratic(desc.element == "tet10"),
      elements(mesh),
      table(bubbles(quadratic)),
      density(desc.density) {
  if (quadratic) tet10.emplace(mesh);
  make_laws(desc, tissue);
  const std::size_t vertices = vertex_count(mesh);
  volume.assign(vertices, 0);
  for (const std::uint32_t source : elements.source()) {
    const double quarter = Tet4Elements::lumped_share(mesh, source);
    space.push_back(4 * quarter);
    all_volume += space.back();
    for (const std::uint32_t node : mesh.tets[source]) volume[node] += quarter;
  }
  const VecX lumped = quadratic ? tet10->lumped_volume() : Tet4Elements::lumped_volume(mesh);
  for (std::size_t i = 0; i < vertices; ++i) {
    const auto node = static_cast<Eigen::Index>(i);
    tie.push_back(lumped[node] > 0 ? ties[node] / lumped[node] : 0);
  }
  make_functions();
  make_faces();
  make_compliance();
  for (auto* by_element : {&S, &Q, &R}) by_element->assign(element_count(), Mat3::Identity());
  law.assign(element_count(), {});
  residual.assign(functions.size(), Vec3::Zero());
  reaction.assign(vertices, Vec3::Zero());
  disc.assign(vertices, 0);
  model.assign(vertices, 0);
  newest.local.assign(vertices, 0);
  if (mesh.stretch == nullptr) return;
  // Tissue is under tension at rest: only loads beyond the rest state move it.
  moment.x.resize(3 * static_cast<Eigen::Index>(mesh.positions.size()));
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    moment.x.segment<3>(3 * static_cast<Eigen::Index>(i)) = mesh.positions[i];
  moment.acceleration = moment.slip = VecX::Zero(moment.x.size());
  clear();
  for (std::size_t k = 0; k < piece_count(); ++k) piece(k);
  keep(rest);
}

void BodyEstimator::Work::make_laws(const SoftDesc& desc, const std::string& tissue) {
  const Materials all = make_materials(desc, mesh), own = all.at(elements.source());
  const SplitMaterials split = split_volume(own);
  for (std::size_t k = 0; k < own.kinds.size(); ++k) {
    MaterialLaws& laws_of_kind = laws.emplace_back();
    const Material& local = quadratic ? split.local.kinds[k] : own.kinds[k];
    laws_of_kind.own = make_law(desc.model, local);
    if (desc.model != tissue) laws_of_kind.tissue = make_law(tissue, local);
    laws_of_kind.lame = own.kinds[k].lame;
    laws_of_kind.local = split.local.kinds[k].lame;
    laws_of_kind.mean = split.mean.empty() ? 0 : split.mean[k];
  }
  for (std::size_t e = 0; e < element_count(); ++e)
    kind.push_back(static_cast<std::uint32_t>(own.kind_of(e)));
}

void BodyEstimator::Work::make_functions() {
  for (std::size_t e = 0; e < element_count(); ++e)
    for (const Bubble& bubble : table.of_tet)
      functions.add(FunctionIndex::key(bubble.corners, elements.nodes(e)));
  functions.close();
  owner.assign(functions.size(), 0);
  for (std::size_t e = element_count(); e-- > 0;)
    for (const Bubble& bubble : table.of_tet) {
      const std::uint32_t k = functions.find(FunctionIndex::key(bubble.corners, elements.nodes(e)));
      owner[k] = static_cast<std::uint32_t>(e);
    }
  for (std::size_t e = 0; e < element_count(); ++e)
    for (const Bubble& bubble : table.of_tet)
      function.push_back(functions.find(FunctionIndex::key(bubble.corners, elements.nodes(e))));
}

void BodyEstimator::Work::make_faces() {
  area.assign(volume.size(), 0);
  for (OuterFace face : outer_faces(mesh)) {
    std::sort(face.begin(), face.end());
    std::array<std::uint32_t, 8> found{};
    bool all_there = true;  // false for faces of elements that were left out
    for (std::size_t k = 0; k < table.of_face.size(); ++k) {
      const auto key = FunctionIndex::key(table.of_face[k].corners, face);
      found[k] = functions.find(key);
      all_there = all_there && found[k] < functions.size() && functions[found[k]] == key;
    }
    if (!all_there) continue;
    faces.push_back(face);
    face_function.insert(face_function.end(), found.begin(),
                         found.begin() + static_cast<std::ptrdiff_t>(table.of_face.size()));
    for (const std::uint32_t node : face) area[node] += area_vector(mesh, face).norm() / 3;
  }
}

void BodyEstimator::Work::make_compliance() {
  std::vector<Mat3> K(functions.size(), Mat3::Zero());
  for (std::size_t e = 0; e < element_count(); ++e) {
    const MaterialLaws& law = laws[kind[e]];
    const Columns b = slopes(e);
    const double V = elements.volume(e);
    for (std::size_t k = 0; k < table.of_tet.size(); ++k) {
      const Bubble& bubble = table.of_tet[k];
      const Mat3 G = b * bubble.stiffness * b.transpose();
      const Vec3 mean = b * bubble.slope;
      double least_tie = std::numeric_limits<double>::infinity();
      for (const std::size_t c : bubble.corners) least_tie = std::min(least_tie, tie[elements.nodes(e)[c]]);
      K[function[e * table.of_tet.size() + k]] +=
          V * (law.local.mu * (G.trace() * Mat3::Identity() + G) + law.local.lambda * G +
               law.mean * mean * mean.transpose() + least_tie * bubble.square * Mat3::Identity());
    }
  }
  for (const Mat3& stiffness : K) compliance.push_back(stiffness.inverse());
}

/// Returns the gradients of the corners' barycentric coordinates at rest, 1/m.
Columns BodyEstimator::Work::slopes(std::size_t e) const {
  Columns b;
  b.rightCols<3>() = elements.gradients(e);
  b.col(0) = -b.rightCols<3>().rowwise().sum();
  return b;
}

void BodyEstimator::Work::clear() {
  done = 0;
  std::fill(residual.begin(), residual.end(), Vec3::Zero());
  std::fill(reaction.begin(), reaction.end(), Vec3::Zero());
  std::fill(disc.begin(), disc.end(), 0);
  std::fill(model.begin(), model.end(), 0);
  mean_F.setZero();
  all = press = {};
  slip = 0;
}

void BodyEstimator::Work::piece(std::size_t k) {
  if (k < element_count()) return add_element(k);
  k -= element_count();
  if (k < faces.size()) return add_face(k);
  k -= faces.size();
  if (k < functions.size()) return add_function(k);
  finish();
}

void BodyEstimator::Work::linear_state(std::size_t e, const VecX& x, ElementState& out) const {
  const MaterialLaws& law = laws[kind[e]];
  const Mat3 F = elements.edges(e, x.data()) * elements.gradients(e).transpose();
  Mat3 P;
  law.own->stress({&F, 1}, {}, {&P, 1});
  out.R = polar(F).R;
  out.P.fill(P);
  out.S = out.R.transpose() * F;
  out.Q = out.R.transpose() * P;
  out.work = P.cwiseProduct(F - out.R).sum();
  if (law.tissue) out.law = law_difference(*law.tissue, 0, {{&F, 1}, {&out.R, 1}, {&P, 1}});
}

void BodyEstimator::Work::quadratic_state(std::size_t e, const VecX& x, ElementState& out) const {
  const MaterialLaws& law = laws[kind[e]];
  std::array<double, 48> moved;
  tet10->move(e, x.data(), moved.data());
  std::array<Mat3, 4> F, P, R;
  std::array<double, 4> dilatation, pressure;
  for (std::size_t q = 0; q < 4; ++q) {
    const Eigen::Map<const Columns> D(moved.data() + 12 * q);
    F[q] = (D.rightCols<3>().colwise() - D.col(0)) * elements.gradients(e).transpose();
  }
  law.own->dilatation(F, dilatation);
  pressure.fill(law.mean * (dilatation[0] + dilatation[1] + dilatation[2] + dilatation[3]) / 4);
  law.own->stress(F, pressure, P);
  out.R = polar((F[0] + F[1] + F[2] + F[3]) / 4).R;
  for (std::size_t q = 0; q < 4; ++q) {
    R[q] = polar(F[q]).R;
    out.work += P[q].cwiseProduct(F[q] - R[q]).sum() / 4;
    out.S += R[q].transpose() * F[q] / 4;
    out.Q += R[q].transpose() * P[q] / 4;
  }
  if (law.tissue) out.law = law_difference(*law.tissue, law.mean, {F, R, P});
  for (int c = 0; c < 4; ++c) {
    out.P[static_cast<std::size_t>(c)].setZero();
    for (int q = 0; q < 4; ++q)
      out.P[static_cast<std::size_t>(c)] += corners_of(c, q) * P[static_cast<std::size_t>(q)];
  }
}

void BodyEstimator::Work::add_element(std::size_t e) {
  ElementState now;
  quadratic ? quadratic_state(e, moment.x, now) : linear_state(e, moment.x, now);
  const double V = elements.volume(e);
  const Corners& nodes = elements.nodes(e);
  const Columns b = slopes(e);
  std::array<Vec3, 4> load;  // N/m³
  Vec3 all_load = Vec3::Zero();
  for (std::size_t c = 0; c < 4; ++c) {
    load[c] = density * moment.acceleration.segment<3>(at(nodes[c]));
    all_load += load[c];
  }
  all.weight += space[e] * all_load.norm() / 4;
  const Mat3 mean_P = (now.P[0] + now.P[1] + now.P[2] + now.P[3]) / 4;
  for (std::size_t c = 0; c < 4; ++c)
    reaction[nodes[c]] += V * mean_P * b.col(static_cast<int>(c)) - space[e] / 20 * (load[c] + all_load);
  for (std::size_t k = 0; k < table.of_tet.size(); ++k) {
    const Bubble& bubble = table.of_tet[k];
    Vec3 r = Vec3::Zero();
    double least_tie = std::numeric_limits<double>::infinity();
    for (const std::size_t c : bubble.corners) least_tie = std::min(least_tie, tie[nodes[c]]);
    for (int c = 0; c < 4; ++c) {
      const auto corner = static_cast<std::size_t>(c);
      if (quadratic) r += V * (now.P[corner] * (b * bubble.stress.row(c).transpose()));
      Vec3 f = load[corner];
      if (least_tie > 0)
        f -= std::min(least_tie, tie[nodes[corner]]) *
             (moment.x.segment<3>(at(nodes[corner])) - mesh.positions[nodes[corner]]);
      r -= space[e] * bubble.load[c] * f;
    }
    if (!quadratic) r += V * (mean_P * (b * bubble.slope));
    residual[function[e * table.of_tet.size() + k]] += r;
  }
  S[e] = now.S;
  Q[e] = now.Q;
  R[e] = now.R;
  mean_F += V * now.R * now.S;
  law[e] = now.law;
  const double left_over =
      V * (rest.known ? work_on_top(now.law, rest.law[e], now.S - rest.S[e]) : now.law.work);
  all.law += left_over;
  for (const std::uint32_t node : nodes) model[node] += std::abs(left_over) / 4;
  const auto add_work = [&](Sums& sums, const Baseline& base) {
    if (base.known)
      sums.work += V * (now.Q - base.Q[e]).cwiseProduct(now.S - base.S[e]).sum();
    else
      sums.work += V * now.work;
  };
  add_work(all, rest);
  add_work(press, quiet.known ? quiet : rest);
  const Mat3 moved =
      now.R.transpose() * elements.edges(e, moment.slip.data()) * elements.gradients(e).transpose();
  const Mat3 strain = (moved + moved.transpose()) / 2;
  const Lame& lame = laws[kind[e]].lame;
  slip += V * (2 * lame.mu * strain.squaredNorm() + lame.lambda * strain.trace() * strain.trace());
}

/// Treats the unbalanced forces at a face's vertices as a surface traction that is linear over the face.
void BodyEstimator::Work::add_face(std::size_t f) {
  const OuterFace& face = faces[f];
  const double size = area_vector(mesh, face).norm();
  std::array<Vec3, 3> traction;
  for (std::size_t c = 0; c < 3; ++c)
    traction[c] = tie[face[c]] > 0 ? Vec3(Vec3::Zero()) : Vec3(reaction[face[c]] / area[face[c]]);
  for (std::size_t k = 0; k < table.of_face.size(); ++k) {
    Vec3& r = residual[face_function[f * table.of_face.size() + k]];
    for (int c = 0; c < 3; ++c) r -= size * table.of_face[k].load[c] * traction[static_cast<std::size_t>(c)];
  }
}

/// Returns r·K⁻¹·r of a function, J, with the residual that exceeds a baseline.
double BodyEstimator::Work::above(const Baseline& base, std::size_t k, const Vec3& r) const {
  Vec3 more = r;
  if (base.known) more -= polar(mean_F).R * base.turn.transpose() * base.residual[k];
  const Vec3 turned = R[owner[k]].transpose() * more;
  return turned.dot(compliance[k] * turned);
}

/// Adds the powers of the forces on outer vertices that exceed a baseline.
void BodyEstimator::Work::add_forces(const Baseline& base, Sums& sums) const {
  const Mat3 turn = base.known ? Mat3(polar(mean_F).R * base.turn.transpose()) : Mat3(Mat3::Zero());
  for (std::size_t i = 0; i < reaction.size(); ++i) {
    if (area[i] == 0 || tie[i] > 0) continue;
    Vec3 force = reaction[i];
    if (base.known) force -= turn * base.reaction[i];
    sums.squares += force.squaredNorm();
    sums.fourths += force.squaredNorm() * force.squaredNorm();
  }
}

/// Returns the calibration factor of η². It is larger where a load acts on few vertices: such a load is finer
/// than the mesh, which the residual does not show.
double BodyEstimator::Work::surplus_share(const Sums& sums) const {
  const Surplus& surplus = quadratic ? quadratic_surplus : linear_surplus;
  if (!(sums.fourths > 0)) return surplus.even;
  // The effective number of loaded vertices. Squared forces make the solver's small residuals on many
  // vertices negligible.
  const double vertices = sums.squares * sums.squares / sums.fourths,
               force = std::sqrt(sums.squares * vertices);
  return surplus.even * (1 + force / (force + sums.weight) * surplus.concentrated / vertices);
}

void BodyEstimator::Work::add_function(std::size_t k) {
  const double found = above(rest, k, residual[k]);
  all.surplus += found;
  press.surplus += quiet.known ? above(quiet, k, residual[k]) : found;
  const auto& corners = functions[k];
  const bool edge = corners[1] == corners[2];
  for (std::size_t c = 0; c < (edge ? 2 : 3); ++c) disc[corners[c]] += found / (edge ? 2 : 3);
}

void BodyEstimator::Work::finish() {
  newest.error = newest.press = newest.pressed = 0;
  newest.parts = {};
  std::fill(newest.local.begin(), newest.local.end(), 0);
  const double negligible = negligible_strain * negligible_strain * all_volume * laws.front().lame.mu;
  if (std::abs(all.work) < negligible) return;  // no load
  if (all.work < 0) {                           // the stress does work on the loads
    newest.error = newest.press = max_reported_error;
    return;
  }
  add_forces(rest, all);
  add_forces(quiet.known ? quiet : rest, press);
  if (!quiet.known) press.weight = all.weight;  // else the volume forces are in the baseline
  const double d = finite(surplus_share(all) * all.surplus / all.work);
  const double law = finite(all.law / all.work);
  // Where tissue is stiffer, the first-order difference is limited: a compliance can't be negative.
  const double m = law < 0 ? law / (1 - law) : law;
  newest.parts.discretisation = finite(d / (1 + d + m));
  newest.parts.model = finite(m / (1 + d + m));
  newest.parts.solver = finite(moment.solver);
  newest.parts.time = finite(std::sqrt(slip / all.work));
  const auto together = [](double a, double b) {
    return std::max(std::abs(a + b), doubt * std::max(std::abs(a), std::abs(b)));
  };
  newest.error = finite(together(newest.parts.discretisation, newest.parts.model) + newest.parts.solver +
                        newest.parts.time);
  // The contact's own compliance has a share of the dent that the elements lack.
  const double pressed_d = surplus_share(press) * press.surplus, pressed_m = m * press.work - moment.give;
  newest.press = finite(together(pressed_d, pressed_m) / (press.work + moment.give) + newest.parts.solver);
  newest.pressed = press.work / all.work;
  const double weight_d = std::abs(d), weight_m = std::abs(m), weight = weight_d + weight_m;
  double all_model = 0, all_disc = 0;
  for (std::size_t i = 0; i < volume.size(); ++i) {
    all_model += model[i];
    all_disc += disc[i];
  }
  for (std::size_t i = 0; i < volume.size(); ++i) {
    double part = 0;
    if (weight > 0 && volume[i] > 0)
      part = ((all_disc > 0 ? weight_d * disc[i] / all_disc : 0) +
              (all_model > 0 ? weight_m * model[i] / all_model : 0)) /
             weight * all_volume / volume[i];
    newest.local[i] = newest.error * part;
  }
}

void BodyEstimator::Work::keep(Baseline& base) const {
  base.S = S;
  base.Q = Q;
  base.residual = residual;
  base.reaction = reaction;
  base.turn = polar(mean_F).R;
  base.law = law;
  base.known = true;
}

bool BodyEstimator::judges(const SoftDesc& desc, const TetMesh& mesh) {
  return !mesh.tets.empty() && std::any_of(prosector::laws().begin(), prosector::laws().end(),
                                           [&](const LawRow& row) { return row.name == desc.model; });
}

BodyEstimator::BodyEstimator(const SoftDesc& desc, const TetMesh& mesh, const VecX& ties,
                             const std::string& tissue)
    : work_(std::make_unique<Work>(desc, mesh, ties, tissue)) {}
BodyEstimator::~BodyEstimator() = default;
BodyEstimator::BodyEstimator(BodyEstimator&&) noexcept = default;

std::size_t BodyEstimator::pieces() const {
  return work_->piece_count();
}

void BodyEstimator::begin(BodyMoment& moment) {
  std::swap(work_->moment, moment);
  work_->clear();
}

bool BodyEstimator::go_on(std::size_t pieces) {
  Work& w = *work_;
  const std::size_t end = std::min(w.done + pieces, w.piece_count());
  for (; w.done < end; ++w.done) w.piece(w.done);
  return w.done == w.piece_count();
}

const Estimate& BodyEstimator::newest() const {
  return work_->newest;
}

void BodyEstimator::keep_as_quiet() {
  work_->keep(work_->quiet);
}

const TetMesh& BodyEstimator::mesh() const {
  return work_->mesh;
}

}  // namespace prosector
