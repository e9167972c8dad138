#pragma once
// A bonded elastic layer with fine cells where a ball is pressed into its middle.

#include "common/mesh.h"

namespace prosector::test {

/// A layer of the given height under y = 0, three times as far to every side; cells of about `cell` m within
/// `core` m of the origin, beyond each wider than the last by `growth`.
Anatomy pressed_layer(double height, double core, double cell, double growth = 1.35);

/// A layer under y = 0 in even cells of about `cell` m, square from above; its surface is its boundary.
Anatomy even_layer(double width, double height, double cell);

/// Puts a surface vertex on the middle of each edge too, as the nodes of quadratic elements are.
void halve_surface(Anatomy& anatomy);

}  // namespace prosector::test
