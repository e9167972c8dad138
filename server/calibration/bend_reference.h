#pragma once
// How far the beam of beam_piece.h bends under its own weight, by each law's continuum.

#include <optional>
#include <string>

namespace prosector {

/// Poisson ratios for which there are references.
inline constexpr double bend_ratios[] = {0.3, 0.45};

/// m: −u_y of the free face's centre at rest, to about 0.02 %, converged over mesh refinement with quadratic
/// elements; of that law's own continuum. Nothing for models that have none. `poisson_ratio`: one of
/// bend_ratios.
std::optional<double> continuum_sag(const std::string& model, double poisson_ratio);

/// What tissue does: the hyperelastic laws agree to 0.4 %. Models without a continuum of their own, and the
/// linear one, which has no business bending that far, are held against this.
double tissue_sag(double poisson_ratio);

}  // namespace prosector
