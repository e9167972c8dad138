#pragma once
// How far the beam of beam_piece.h bends under its own weight, by each law's continuum.

#include <array>
#include <optional>
#include <string>

namespace prosector {

/// Poisson ratios for which there are references, rising.
inline constexpr std::array bend_ratios = {0.3, 0.45, 0.49, 0.499};

/// Returns −u_y (m) of the free face's centre at rest, of the model's own continuum, converged over mesh
/// refinement with quadratic elements. It holds to about 0.02 % up to ν = 0.45, to 0.2 % above. Above, the
/// hyperelastic ones are the linear law's value times their ratio to it on one mesh of 1,536 elements, which
/// at 0.45 is right to 0.1 %. Returns nothing for models that have no continuum. `poisson_ratio` is one of
/// bend_ratios; else std::logic_error is thrown.
std::optional<double> continuum_sag(const std::string& model, double poisson_ratio);

/// Returns what tissue does (m): the hyperelastic laws agree to 0.4 %. Models without a continuum of their
/// own, and the linear one, which has no business bending that far, are held against this.
double tissue_sag(double poisson_ratio);

}  // namespace prosector
