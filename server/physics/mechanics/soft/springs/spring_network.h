#pragma once
// Springs between nodes, and bending of lines of nodes, for ropes, sheets and mass-spring solids.
//
// The constants follow from E, ν and thickness t or diameter d, so that under small homogeneous strain the
// network stores the energy of the continuum:
//   rope, piece of length l:       k = E·A/l,  A = πd²/4;     bending E·I, I = πd⁴/64
//   sheet, cell a × b (plane stress C₁₁ = Et/(1−ν²), G = Et/2(1+ν)):
//     diagonals  k = G(a² + b²)/(2ab);   edges along a: k = (b/a)(C₁₁ − G·a²/b²), half on the border;
//     bending    D = Et³/12(1−ν²)
//   sheet, triangle of area A (of a cell that was cut): k = 8C₁₁·A/9l² at an edge of length l: exact in
//     tension on average over directions; bending ½D·l²/(A₁ + A₂)·(jump of slope)² at an edge between two:
//     exact in every direction for regular triangles
//   tetrahedra: k = Σ 5μV/(2l²) over those at an edge of length l: isotropic on average, with λ = μ, that is
//     ν = ¼, as for any network of central forces. Volume springs ½(λ−μ)V(J−1)² correct λ. (Lloyd et
//     al. 2007 match regular tetrahedra instead.)

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/mesh.h"
#include "common/scene/scene.h"

namespace prosector {

/// Spring with energy ½k(l − l₀)².
struct Spring {
  std::array<std::uint32_t, 2> node;  // ascending
  double rest, stiffness;             // m, N/m

  std::span<const std::uint32_t> nodes() const { return node; }
};

/// Bending element with energy ½s|Σ wᵢxᵢ|², invariant under rotation, and under uniform stretching if
/// straight at rest. It consists of three nodes of a line or of two triangles.
///
/// For a line, x₁ is the middle node, with w = (l̄/a, −l̄/a − l̄/b, l̄/b) for pieces of lengths a and b with mean
/// l̄: (1, −2, 1) for equal ones. With s = EI/l̄³ this is the bending energy of a rod (Bergou et al. 2006). For
/// two triangles, x₀, x₁ are the ends of the common edge, and x₂, x₃ the opposite corners. Σ wᵢxᵢ is the jump
/// of the surface's slope at the edge.
struct Bend {
  std::array<std::uint32_t, 4> node;
  double stiffness;  // N/m
  std::array<double, 4> weight = {1, -2, 1, 0};
  std::uint32_t count = 3;  // number of nodes

  std::span<const std::uint32_t> nodes() const { return std::span(node).first(count); }
};

/// Returns the bend of a line whose pieces have rest lengths a and b (m).
Bend line_bend(const std::array<std::uint32_t, 3>& line, double stiffness, double a, double b);

struct SpringNetwork {
  std::vector<Spring> springs;
  std::vector<Bend> bends;
  VecX rest;                // 3n, m
  VecX volume;              // n, m³
  std::size_t dropped = 0;  // number of springs of zero length, left out
};

/// Creates the springs of the anatomy's segments, quads or tetrahedra. Throws InputError for constants out of
/// range.
SpringNetwork make_spring_network(const SoftDesc& desc, const Anatomy& anatomy);

}  // namespace prosector
