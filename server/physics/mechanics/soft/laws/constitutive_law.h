#pragma once
// Hyperelastic laws: energy, stress and tangent from the deformation gradient.

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "common/math.h"
#include "server/physics/mechanics/soft/laws/material.h"

namespace prosector::soft {

using Mat9 = Eigen::Matrix<double, 9, 9>;

/// Hyperelastic material law: energy density W, stress and tangent as functions of the deformation gradient
/// F. Functions work on batches of elements; all spans have one entry per element. Every law reduces to
/// linear elasticity at F = I: C₁₁₁₁ = λ + 2μ, C₁₁₂₂ = λ, C₁₂₁₂ = μ.
class ConstitutiveLaw {
 public:
  virtual ~ConstitutiveLaw() = default;
  /// Returns whether the law is objective: W(QF) = W(F) for each rotation Q, so that rotating a body causes
  /// no stress.
  virtual bool objective() const { return true; }
  /// Computes the strain energy density W, J/m³, for each deformation gradient in F.
  virtual void energy_density(std::span<const Mat3> F, std::span<double> W) const = 0;
  /// Computes the first Piola stress, Pa, for each deformation gradient in F: P = ∂(W + p·θ)/∂F. p is an
  /// external pressure from `pressure` (Pa; empty: none). θ is the law's measure of volume change
  /// (mean_dilatation.h).
  virtual void stress(std::span<const Mat3> F, std::span<const double> pressure, std::span<Mat3> P) const = 0;
  /// Computes the derivative ∂vec(P)/∂vec(F) of the first Piola stress, Pa, for each deformation gradient in
  /// F. vec lists a matrix column by column. P includes p·∂θ/∂F for the external pressures p in `pressure`
  /// (Pa; empty: none). Negative eigenvalues are projected to 0, so that Newton directions descend; isotropic
  /// laws project exactly, by known eigenvectors. The result is finite for every finite F.
  virtual void tangent(std::span<const Mat3> F, std::span<const double> pressure,
                       std::span<Mat9> dPdF) const = 0;
  /// Computes the law's measure of volume change θ, for example J − 1, for each deformation gradient in F.
  /// The energy density W contains λ/2·θ².
  virtual void dilatation(std::span<const Mat3> F, std::span<double> theta) const = 0;
  virtual void dilatation_gradient(std::span<const Mat3> F, std::span<Mat3> gradient) const = 0;  // ∂θ/∂F
};

/// Row of the table of material laws: a value of `model` in a scene file, its help text, and the factory of
/// the law.
struct LawRow {
  const char* name;
  const char* help;
  std::unique_ptr<ConstitutiveLaw> (*make)(const Material&);
};
const std::vector<LawRow>& laws();
/// Returns whether the table of material laws, laws(), has a row with this name.
bool is_law(const std::string& name);
/// Creates the material law called `name` with these constants. Throws InputError that lists the known names
/// if there is none.
std::unique_ptr<ConstitutiveLaw> make_law(const std::string& name, const Material& constants);

}  // namespace prosector::soft
