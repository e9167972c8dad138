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

namespace prosector::soft {

/// Spring between two nodes, with energy ½k(l − l₀)², where k is the stiffness (N/m), l its length and l₀ its
/// rest length (m).
struct Spring {
  std::array<std::uint32_t, 2> node;  // ascending
  double rest, stiffness;             // m, N/m

  std::span<const std::uint32_t> nodes() const { return node; }
};

/// Bending element with energy ½s|Σ wᵢxᵢ|², where s is the stiffness, xᵢ the positions of its nodes and wᵢ
/// their weights. It is invariant under rotation, and under uniform stretching if straight at rest. It has
/// the three nodes of a line, or the four nodes of two triangles with a common edge.
///
/// For a line, x₁ is the middle node, with w = (l̄/a, −l̄/a − l̄/b, l̄/b) for pieces of lengths a and b with
/// mean l̄: (1, −2, 1) for equal ones. With s = EI/l̄³ this is the bending energy of a rod (Bergou et al.
/// 2006). For two triangles, x₀, x₁ are the ends of the common edge, and x₂, x₃ the opposite corners. Σ wᵢxᵢ
/// is the jump of the surface's slope at the edge.
struct Bend {
  std::array<std::uint32_t, 4> node;
  double stiffness;  // N/m
  std::array<double, 4> weight = {1, -2, 1, 0};
  std::uint32_t count = 3;  // number of nodes

  std::span<const std::uint32_t> nodes() const { return std::span(node).first(count); }
};

/// Returns the bending element of a line of three nodes, the second of which is in the middle. `a` and `b`:
/// rest lengths of its two pieces, m. `stiffness`: factor s in its energy ½s|Σ wᵢxᵢ|², N/m.
Bend line_bend(const std::array<std::uint32_t, 3>& line, double stiffness, double a, double b);

struct SpringNetwork {
  std::vector<Spring> springs;
  std::vector<Bend> bends;
  VecX rest;                // 3n, m
  VecX volume;              // n, m³
  std::size_t dropped = 0;  // number of springs without length or stiffness, left out
};

/// Creates the springs and bending elements of a rope, a sheet or a mass-spring solid, from its segments,
/// cells or tetrahedra. Throws InputError for constants out of range.
SpringNetwork make_spring_network(const SoftMaterial& material, const Anatomy& anatomy);

}  // namespace prosector::soft
