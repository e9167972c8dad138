// Extended position-based dynamics (Macklin et al. 2016) in small substeps of one sweep each (2019):
// springs, bends, and on tetrahedra the stable neo-Hookean pair of constraints (Macklin & Müller 2021),
//   C_D = ‖F‖, compliance 1/(μV),   C_H = J − (1 + μ/Λ), compliance 1/(ΛV),   Λ = λ + μ,
// with the energy of fem_neo_hookean_polynomial. Compliances follow from the physical springs, so stiffness
// does not depend on the number of substeps and needs no tuning, as long as the sweeps converge.
//
// Constraints are coloured: those of one colour share no node, so they run in parallel with bitwise equal
// results for any number of threads.

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "server/physics/base/parallel.h"
#include "server/physics/mechanics/soft/base/effort.h"
#include "server/physics/mechanics/soft/elements/tet4.h"
#include "server/physics/mechanics/soft/integrators/substepper.h"
#include "server/physics/mechanics/soft/laws/constitutive_law.h"
#include "server/physics/mechanics/soft/springs/spring_network.h"
#include "server/physics/mechanics/soft/xpbd/node_colours.h"

namespace prosector::soft {
namespace {

constexpr std::size_t constraints_per_chunk = 256;
// Factor per tick by which the number of substeps beyond the described one decreases.
constexpr double relaxed = 0.97;
// Factor on the maximum number of substeps after that number was not sufficient: with `relaxed`, the next try
// is 90 ticks later. Each try takes as long as that many substeps.
constexpr int given_up = 16;
// Ratio of needed to taken substeps below which no additional substeps are needed any more.
constexpr double settled = 0.5;

struct Element {
  enum class Kind : std::uint8_t { spring, bend, tet } kind;
  std::uint32_t index;
};

class XpbdSubstepper final : public Substepper {
 public:
  XpbdSubstepper(const SubstepBody& body, const Anatomy& anatomy)
      : body_(body), tets_(anatomy.tets), network_(tets_.size() == 0 ? body.model.springs() : nullptr) {
    if (tets_.size() > 0) {
      materials_ = make_materials(body.desc.material, anatomy.tets, true).at(tets_.source());
      const auto beyond = [](double ratio) { return 2 * ratio / (1 - 2 * ratio) > most_xpbd_lambda; };
      bounded_ = beyond(body.desc.material.poisson_ratio);
      for (const RegionDesc& region : body.desc.material.regions)
        bounded_ = bounded_ || beyond(region.poisson_ratio);
    }
    fit();
  }

  void follow(const TetMesh& mesh, const MeshEdit& edit) override {
    tets_.follow(mesh, edit);
    materials_.follow(body_.desc.material, mesh, edit);
  }
  void fit() override {
    inverse_mass_ = body_.mass.cwiseInverse();
    colour();
  }
  void initialise(SoftBodyState&) override {}
  double needed(double h, const SoftBodyState& state) const override {
    return std::max<double>(effort_of(body_.desc.configuration, state.steps_down).substeps,
                            std::round(h * state.omega));
  }
  int allowed() const override {
    return std::max(body_.desc.configuration.substeps, body_.desc.configuration.max_substeps);
  }
  bool has_limit() const override { return false; }
  const char* remark() const override {
    return bounded_ ? "; the body's poisson_ratio is limited to 0.499" : "";
  }
  double most_gain(double) const override { return 1.002; }
  double most_pushed(double) const override { return 2; }  // work of the push, and strain energy from it
  void begin(const SoftBodyState&) override {}
  bool finish(double hs, SoftBodyState& state) override {
    state.omega = hs > 0 && hs * state.omega < settled ? 0 : relaxed * state.omega;
    return state.motion.x.allFinite();
  }
  /// Halves the length of substeps. One sweep leaves energy in constraints that are stiff for a substep: a
  /// quarter with half the length. If the maximum number is not sufficient, no more substeps are tried until
  /// `relaxed` has reduced the need to that maximum.
  bool refine(double h, int taken, SoftBodyState& state) const override {
    const bool more = taken < allowed();
    state.omega = (more ? std::min(2 * taken, allowed()) : given_up * taken) / h;
    return more;
  }

  void step(double hs, const Weight& weight, SoftBodyState& state) override {
    VecX &x = state.motion.x, &v = state.motion.v;
    x_ = x.data();
    start_ = x;
    weight.add(hs, v);
    v *= std::exp(-hs * body_.desc.material.damping_mass);
    x += hs * v;
    hold_attachments(hs);
    for (std::size_t c = 0; c + 1 < colour_begin_.size(); ++c)
      parallel_chunks(colour_begin_[c + 1] - colour_begin_[c], constraints_per_chunk,
                      [&](std::size_t first, std::size_t last, std::size_t) {
                        for (std::size_t k = first; k < last; ++k) project(order_[colour_begin_[c] + k], hs);
                      });
    v = (x - start_) / hs;
  }

 private:
  Eigen::Map<Vec3> at(std::uint32_t node) { return Eigen::Map<Vec3>(x_ + 3 * std::size_t{node}); }
  Eigen::Map<const Vec3> before(std::uint32_t node) const {
    return Eigen::Map<const Vec3>(start_.data() + 3 * std::size_t{node});
  }

  std::span<const std::uint32_t> nodes(const Element& e) const {
    if (e.kind == Element::Kind::spring) return network_->springs[e.index].node;
    if (e.kind == Element::Kind::bend) return network_->bends[e.index].nodes();
    return tets_.nodes(e.index);
  }

  /// Colours the constraints greedily: each gets the first colour that none of its nodes has.
  void colour() {
    std::vector<Element> elements;
    const auto add = [&](Element::Kind kind, std::size_t count) {
      for (std::uint32_t i = 0; i < count; ++i) elements.push_back({kind, i});
    };
    if (network_ != nullptr) {
      elements.reserve(network_->springs.size() + network_->bends.size());
      add(Element::Kind::spring, network_->springs.size());
      add(Element::Kind::bend, network_->bends.size());
    }
    add(Element::Kind::tet, tets_.size());
    NodeColours taken(static_cast<std::size_t>(body_.mass.size()));
    std::vector<std::uint32_t> colours;
    colours.reserve(elements.size());
    colour_begin_.assign(1, 0);
    for (const Element& e : elements) {
      const std::uint32_t colour = colours.emplace_back(taken.take_first_free(nodes(e)));
      colour_begin_.resize(std::max<std::size_t>(colour_begin_.size(), colour + 2));
      ++colour_begin_[colour + 1];
    }
    std::partial_sum(colour_begin_.begin(), colour_begin_.end(), colour_begin_.begin());
    order_.resize(elements.size());
    std::vector<std::size_t> next(colour_begin_.begin(), colour_begin_.end() - 1);
    for (std::size_t i = 0; i < elements.size(); ++i) order_[next[colours[i]]++] = elements[i];
  }

  /// Applies a node's attachment spring and its damping in closed form. Together with inertia they form one
  /// quadratic potential of weight m + k·hs² + βk·hs about a point in between. From here on constraints use
  /// this weight as the node's mass.
  void hold_attachments(double hs) {
    const VecX& rest = body_.model.rest();
    for (Eigen::Index i = 0; i < body_.mass.size(); ++i) {
      const double k = body_.attached[i] * hs * hs, c = k * body_.desc.material.damping_stiffness / hs;
      if (!(k > 0)) continue;
      Eigen::Map<Vec3> x(x_ + 3 * i);
      inverse_mass_[i] = 1 / (body_.mass[i] + k + c);
      x -= inverse_mass_[i] * (k * (x - rest.segment<3>(3 * i)) + c * (x - start_.segment<3>(3 * i)));
    }
  }

  /// Moves a constraint's nodes by one sweep, starting from λ = 0: Δλ = (−C − γ∇C·(x − x_n)) / ((1 +
  /// γ)·∇C·M⁻¹·∇Cᵀ + α̃), x += M⁻¹∇Cᵀ·Δλ. Here α̃ = 1/(k·hs²), and γ = β/hs for damping β·k (Macklin et al.
  /// 2016, eq. 26).
  void move(std::span<const std::uint32_t> node, const Vec3* gradient, double C, double k, double hs) {
    double mobility = 0, drift = 0;
    for (std::size_t a = 0; a < node.size(); ++a) {
      mobility += inverse_mass_[node[a]] * gradient[a].squaredNorm();
      drift += gradient[a].dot(at(node[a]) - before(node[a]));
    }
    const double gamma = body_.desc.material.damping_stiffness / hs;
    const double change = (-C - gamma * drift) / ((1 + gamma) * mobility + 1 / (k * hs * hs));
    if (!std::isfinite(change)) return;
    for (std::size_t a = 0; a < node.size(); ++a)
      at(node[a]) += inverse_mass_[node[a]] * change * gradient[a];
  }

  void project(const Element& e, double hs) {
    if (e.kind == Element::Kind::spring)
      project_spring(network_->springs[e.index], hs);
    else if (e.kind == Element::Kind::bend)
      project_bend(network_->bends[e.index], hs);
    else
      project_tet(e.index, hs);
  }

  void project_spring(const Spring& s, double hs) {
    const Vec3 d = at(s.node[1]) - at(s.node[0]);
    const double length = d.norm();
    if (!(length > 0)) return;
    const Vec3 n = d / length, gradient[2] = {-n, n};
    move(s.node, gradient, length - s.rest, s.stiffness, hs);
  }

  void project_bend(const Bend& b, double hs) {
    const auto& w = b.weight;
    Vec3 d = w[0] * at(b.node[0]) + w[1] * at(b.node[1]) + w[2] * at(b.node[2]);
    if (b.count > 3) d += w[3] * at(b.node[3]);
    const double C = d.norm();
    if (!(C > 0)) return;
    const Vec3 n = d / C, gradient[4] = {w[0] * n, w[1] * n, w[2] * n, w[3] * n};
    move(b.nodes(), gradient, C, b.stiffness, hs);
  }

  /// Projects both constraints of a tetrahedron together, so that nothing moves at rest, where neither is 0
  /// but their forces cancel:
  ///   ((1 + γ)A + α̃)Δλ = −C − γ∇C·(x − x_n),  A = ∇C·M⁻¹·∇Cᵀ.
  void project_tet(std::size_t e, double hs) {
    const double V = tets_.volume(e), gamma = body_.desc.material.damping_stiffness / hs;
    const auto [lambda, mu] = materials_.of(e).lame;
    const double volume_modulus = lambda + mu;
    const Mat3 F = tets_.edges(e, x_) * tets_.gradients(e).transpose();
    const double norm = F.norm();
    Mat3 cofactor;
    cofactor << F.col(1).cross(F.col(2)), F.col(2).cross(F.col(0)), F.col(0).cross(F.col(1));
    Tet4Elements::Forces shape, volume;  // ∇C_D, ∇C_H
    tets_.forces(e, norm > 0 ? Mat3(F / (V * norm)) : Mat3(Mat3::Zero()), shape);
    tets_.forces(e, cofactor / V, volume);
    const auto& node = tets_.nodes(e);
    Eigen::Matrix2d A = Eigen::Matrix2d::Zero();
    Eigen::Vector2d drift = Eigen::Vector2d::Zero();
    for (std::size_t a = 0; a < node.size(); ++a) {
      const double w = inverse_mass_[node[a]];
      const Vec3 moved = at(node[a]) - before(node[a]);
      A(0, 0) += w * shape[a].squaredNorm();
      A(0, 1) += w * shape[a].dot(volume[a]);
      A(1, 1) += w * volume[a].squaredNorm();
      drift += Eigen::Vector2d(shape[a].dot(moved), volume[a].dot(moved));
    }
    A(1, 0) = A(0, 1);
    A *= 1 + gamma;
    A(0, 0) += 1 / (mu * V * hs * hs);
    A(1, 1) += 1 / (volume_modulus * V * hs * hs);
    const Eigen::Vector2d C(norm, F.determinant() - (1 + mu / volume_modulus));
    const Eigen::Vector2d change = -A.inverse() * (C + gamma * drift);
    if (!change.allFinite()) return;
    for (std::size_t a = 0; a < node.size(); ++a)
      at(node[a]) += inverse_mass_[node[a]] * (change[0] * shape[a] + change[1] * volume[a]);
  }

  const SubstepBody body_;
  Tet4Elements tets_;
  const SpringNetwork* network_;  // the model's; null for tetrahedra
  VecX inverse_mass_;             // n, 1/kg; for attached nodes see hold_attachments
  Materials materials_ = Lame{};  // of the tetrahedra
  bool bounded_ = false;          // whether a material was beyond most_xpbd_lambda
  std::vector<Element> order_;    // by colour
  std::vector<std::size_t> colour_begin_;
  double* x_ = nullptr;  // 3n, positions in the substep
  VecX start_;           // 3n, positions at the substep's start
};

}  // namespace

std::unique_ptr<Substepper> make_xpbd_substepper(const SubstepBody& body, const Anatomy& anatomy) {
  return std::make_unique<XpbdSubstepper>(body, anatomy);
}

}  // namespace prosector::soft
