#pragma once
// Reference deflections of the beam of beam_piece.h under its weight, for each law's continuum.

#include <array>
#include <optional>
#include <string>

namespace prosector {

/// Poisson ratios for which there are reference deflections of the beam, in ascending order.
inline constexpr std::array bend_ratios = {0.3, 0.45, 0.49, 0.499};

/// Returns the reference deflection −u_y (m) of the beam's free-face centre at rest under its weight, for the
/// continuum of that model. It is converged over mesh refinement with quadratic elements, to about 0.02 % up
/// to ν = 0.45 and to 0.2 % above. Above 0.45, the hyperelastic values are the linear law's value times their
/// ratio to it on one mesh of 1,536 elements. At 0.45 this estimate is right to 0.1 %. Returns nothing for
/// models that have no continuum. Throws std::logic_error if `poisson_ratio` is not one of bend_ratios.
std::optional<double> continuum_sag(const std::string& model, double poisson_ratio);

/// Returns the deflection (m) of the reference beam's free end under its weight for real tissue, a value on
/// which the hyperelastic laws agree to 0.4 %. It is the reference for models without a continuum, and for
/// the linear law, which is not valid for such large deflections.
double tissue_sag(double poisson_ratio);

}  // namespace prosector
