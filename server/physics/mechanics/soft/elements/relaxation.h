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

namespace prosector::soft {

/// Element batches of any material law with viscoelastic stress relaxation. Between begin_step and end_step,
/// their energy is the one that the step must minimise. Before the first begin_step it is that of the law.
class RelaxingBatches final : public ElementBatches {
 public:
  RelaxingBatches(std::unique_ptr<ElementBatches> law, std::vector<RelaxationDesc> terms,
                  const Materials& materials, const Tet4Elements& elements);

  /// Returns the number of values of the stress history: for each element and each relaxation term six
  /// numbers, the upper triangle of the symmetric stress h_i (Pa).
  std::size_t history_size() const { return history_per_element() * elements_.size(); }
  /// Computes the coefficients of the relaxation terms for the next step of `h` s: the factor c on the law's
  /// stress, the decay factors e_i and the gains γ_i.
  void set_step(double h);
  /// Sets relaxation to complete, as after an infinite time. The factor on the law's stress becomes c = 1 −
  /// Σg_i, with the shares g_i of the relaxation terms, and the stress H from the history becomes 0.
  void relax_fully();
  /// Returns the factor c by which the present step scales the law's instantaneous stress. It also scales
  /// λ'', the part of the bulk stiffness that acts on an element's mean volume change.
  double instant_share() const { return share_; }
  /// Begins a step of the batch: computes from the stress `history` and the stress at the step's start the
  /// stress H that the step adds. The batch must have been moved to the start positions, with its pressures
  /// set.
  void begin_step(std::size_t batch, const double* history);
  /// Ends a time step of this batch of elements: updates their stress `history`. Before, move() must have set
  /// the node positions at the step's end, and set_pressures() the elements' pressures there.
  void end_step(std::size_t batch, double* history) const;

  bool can_follow() const override { return law_->can_follow(); }
  void follow(const SoftMaterial& material, const TetMesh& mesh, const MeshEdit& edit) override;
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
  /// Computes the second Piola stress S (Pa) of the law for each element of the batch at its present
  /// positions. S is set to 0 for flat and inverted elements. For a law that is not objective, computes the
  /// first Piola stress instead.
  void second_piola(std::size_t batch, std::span<Mat3> S) const;

  std::unique_ptr<ElementBatches> law_;
  std::vector<RelaxationDesc> terms_;
  std::vector<double> keep_, gain_;  // e_i, γ_i
  double share_ = 1;                 // c
  std::vector<Mat3> held_;           // by element: H
  std::vector<Mat3> start_;          // by element: S_n
};

/// Creates the element batches of the material law called `law`, with viscoelastic stress relaxation by these
/// `terms`, or without relaxation if there are none. `elements` must outlive the result.
std::unique_ptr<ElementBatches> make_relaxing_batches(const std::string& law, const Materials& materials,
                                                      const std::vector<RelaxationDesc>& terms,
                                                      const Tet4Elements& elements);

/// Returns whether viscoelastic stress relaxation is practically complete. No stress in `history`, the stress
/// history of a state of this body, may exceed a thousandth of Young's modulus.
bool has_relaxed(const SoftMaterial& material, const VecX& history);

}  // namespace prosector::soft
