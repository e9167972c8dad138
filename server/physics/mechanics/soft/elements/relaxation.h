#pragma once
// Viscoelastic relaxation: a Prony series over any law (Simo 1987; Simo & Hughes 1998, §10.3). With S = F⁻¹P
// the law's second Piola stress and shares g_i, times τ_i of the terms,
//   S_v(t) = (1 − Σg_i)·S(t) + Σ h_i(t),   ḣ_i + h_i/τ_i = g_i·Ṡ,   h_i(0) = 0.
// So under constant strain the stress decays from S to (1 − Σg_i)·S as e^(−t/τ_i), and the law describes the
// instantaneous response. Over a step in which S changes linearly, the h_i are known exactly,
//   h_i ← e_i·h_i + γ_i·(S − S_n),   e_i = e^(−h/τ_i),   γ_i = g_i·(1 − e_i)·τ_i/h.
// The step's stress is the gradient of c·W(F) + H : ½FᵀF with c = 1 − Σg_i + Σγ_i and
// H = Σ(e_i·h_i − γ_i·S_n), so a minimiser needs no other data. For the law that is not objective, P itself
// is relaxed, and H : F replaces the last term.

#include <memory>
#include <string>
#include <vector>

#include "server/physics/mechanics/soft/elements/element_batches.h"

namespace prosector {

/// Batches of a law with stress relaxation. Between begin_step and end_step, their energy is the one that the
/// step minimises; before the first begin_step, it is that of the law.
class RelaxingBatches final : public ElementBatches {
 public:
  RelaxingBatches(std::unique_ptr<ElementBatches> law, std::vector<RelaxationDesc> terms,
                  const Materials& materials, const Tet4Elements& elements);

  /// Returns the size of the history: six numbers (h_i's upper triangle, Pa) per term and element.
  std::size_t history_size() const { return history_per_element() * elements_.size(); }
  /// Sets c, e_i and γ_i for the next step of `h` s.
  void set_step(double h);
  /// Sets c = 1 − Σg_i and H = 0: relaxation is complete.
  void relax_fully();
  /// Returns c, by which a step scales λ''.
  double instant_share() const { return share_; }
  /// Begins a step of the batch, which is at x_n with pressures set.
  void begin_step(std::size_t batch, const double* history);
  /// Ends the step of the batch, which is at the end positions with pressures set.
  void end_step(std::size_t batch, double* history) const;

  bool can_follow() const override { return law_->can_follow(); }
  void follow(const SoftDesc& desc, const TetMesh& mesh, const MeshEdit& edit) override;
  bool objective() const override { return law_->objective(); }
  void move(std::size_t batch, const double* x) override;
  double energy(std::size_t batch) const override;
  void forces(std::size_t batch, std::span<Tet4Elements::Forces> f) const override;
  void dilatations(std::size_t batch, std::span<double> theta) const override {
    law_->dilatations(batch, theta);
  }
  void dilatation_forces(std::size_t batch, std::span<Tet4Elements::Forces> G) const override {
    law_->dilatation_forces(batch, G);
  }
  void warped_dilatation_forces(std::size_t batch, std::span<Tet4Elements::Forces> G) const override {
    law_->warped_dilatation_forces(batch, G);
  }
  void set_pressures(std::size_t batch, std::span<const double> pressure) override {
    law_->set_pressures(batch, pressure);
  }
  void stiffness(std::size_t batch, std::span<Tet4Elements::Stiffness> K) const override;
  void warped_stiffness(std::size_t batch, std::span<Tet4Elements::Stiffness> K) const override {
    law_->warped_stiffness(batch, K);
  }

 private:
  std::size_t history_per_element() const { return 6 * terms_.size(); }
  Mat3 gradient(std::size_t batch, std::size_t lane) const;
  /// Computes S of the batch's elements at their positions; 0 for flat and inverted elements.
  void second_piola(std::size_t batch, std::span<Mat3> S) const;

  std::unique_ptr<ElementBatches> law_;
  std::vector<RelaxationDesc> terms_;
  std::vector<double> keep_, gain_;  // e_i, γ_i
  double share_ = 1;                 // c
  std::vector<Mat3> held_;           // by element: H
  std::vector<Mat3> start_;          // by element: S_n
};

/// Creates the batches of the law called `law` in laws(), with relaxation unless `terms` is empty.
std::unique_ptr<ElementBatches> make_relaxing_batches(const std::string& law, const Materials& materials,
                                                      const std::vector<RelaxationDesc>& terms,
                                                      const Tet4Elements& elements);

/// Returns whether relaxation is complete: no h_i exceeds a thousandth of E, so the shape is that of a body
/// held for an infinite time. `history`: of a state of that body.
bool has_relaxed(const SoftDesc& desc, const VecX& history);

}  // namespace prosector
