#pragma once
// Hyperelastic laws: energy, stress and tangent from the deformation gradient.

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "common/math.h"
#include "server/physics/soft/laws/material.h"

namespace prosector {

using Mat9 = Eigen::Matrix<double, 9, 9>;

/// W(F): works on batches of elements so that a law can be vectorised without touching who calls it.
/// All spans have one entry per element. Every law reduces to linear elasticity at F = I:
/// C₁₁₁₁ = λ + 2μ, C₁₁₂₂ = λ, C₁₂₁₂ = μ.
class ConstitutiveLaw {
 public:
  virtual ~ConstitutiveLaw() = default;
  /// Tells whether W(QF) = W(F) for rotations Q.
  virtual bool objective() const { return true; }
  /// Computes W, J/m³.
  virtual void energy_density(std::span<const Mat3> F, std::span<double> W) const = 0;
  /// Computes the first Piola stress P = ∂(W + pθ)/∂F, Pa, with a pressure p (Pa) from outside, see
  /// mean_dilatation.h; `pressure` empty: none.
  virtual void stress(std::span<const Mat3> F, std::span<const double> pressure, std::span<Mat3> P) const = 0;
  /// Computes ∂vec(P)/∂vec(F), Pa, column-major vec. Its negative eigenvalues are projected to 0 so that
  /// Newton descends (isotropic laws project exactly, by known eigenvectors). It is finite for every finite
  /// F.
  virtual void tangent(std::span<const Mat3> F, std::span<const double> pressure,
                       std::span<Mat9> dPdF) const = 0;
  /// Computes θ: the measure of dilatation of whose square W holds λ/2.
  virtual void dilatation(std::span<const Mat3> F, std::span<double> theta) const = 0;
  virtual void dilatation_gradient(std::span<const Mat3> F, std::span<Mat3> gradient) const = 0;  // ∂θ/∂F
};

/// One row of the table of laws: `model` in a scene file.
struct LawRow {
  const char* name;
  const char* help;
  std::unique_ptr<ConstitutiveLaw> (*make)(const Material&);
};
const std::vector<LawRow>& laws();
/// Tells whether one of them has that name.
bool is_law(const std::string& name);
/// Throws InputError that lists the names there are.
std::unique_ptr<ConstitutiveLaw> make_law(const std::string& name, const Material& constants);

}  // namespace prosector
