#pragma once
// What has to hold of tetrahedra whatever was cut.

#include <gtest/gtest.h>

#include "server/physics/mechanics/cutting/tet_complex.h"

namespace prosector {

struct Whole {
  double volume = 0, mass = 0;
  double least_dihedral_deg = 180;
};
Whole whole(const cutting::TetComplex& complex);

/// No inverted element, volume and mass as in `before`, angles above the floor or what they were, every
/// cache as if rebuilt, the boundary of each piece closed, nodes parted where they can be.
::testing::AssertionResult is_sound(const cutting::TetComplex& complex, const Whole& before);

}  // namespace prosector
