#pragma once
// Hyperelastic laws: energy, stress and tangent from the deformation gradient.

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "common/math.h"
#include "server/physics/mechanics/soft/laws/material.h"

namespace prosector {

using Mat9 = Eigen::Matrix<double, 9, 9>;

/// Hyperelastic law W(F). Functions work on batches of elements, so a law can be vectorised without changes
/// to its callers. All spans have one entry per element. Every law reduces to linear elasticity at F = I:
/// C₁₁₁₁ = λ + 2μ, C₁₁₂₂ = λ, C₁₂₁₂ = μ.
class ConstitutiveLaw {
 public:
  virtual ~ConstitutiveLaw() = default;
  /// Returns whether W(QF) = W(F) for rotations Q.
  virtual bool objective() const { return true; }
  /// Computes W, J/m³.
  virtual void energy_density(std::span<const Mat3> F, std::span<double> W) const = 0;
  /// Computes the first Piola stress P = ∂(W + pθ)/∂F, Pa, with an external pressure p (Pa), see
  /// mean_dilatation.h; `pressure` empty: none.
  virtual void stress(std::span<const Mat3> F, std::span<const double> pressure, std::span<Mat3> P) const = 0;
  /// Computes ∂vec(P)/∂vec(F), Pa, with column-major vec. Negative eigenvalues are projected to 0, so that
  /// Newton directions descend (isotropic laws project exactly, by known eigenvectors). The result is finite
  /// for every finite F.
  virtual void tangent(std::span<const Mat3> F, std::span<const double> pressure,
                       std::span<Mat9> dPdF) const = 0;
  /// Computes the law's measure of dilatation θ; W contains λ/2·θ².
  virtual void dilatation(std::span<const Mat3> F, std::span<double> theta) const = 0;
  virtual void dilatation_gradient(std::span<const Mat3> F, std::span<Mat3> gradient) const = 0;  // ∂θ/∂F
};

/// Row of the table of laws: `model` in a scene file.
struct LawRow {
  const char* name;
  const char* help;
  std::unique_ptr<ConstitutiveLaw> (*make)(const Material&);
};
const std::vector<LawRow>& laws();
/// Returns whether a law has this name.
bool is_law(const std::string& name);
/// Throws InputError that lists the known names.
std::unique_ptr<ConstitutiveLaw> make_law(const std::string& name, const Material& constants);

}  // namespace prosector
