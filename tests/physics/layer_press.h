#pragma once
// The finite-layer table: a rigid ball pressed into a bonded layer, frictionless, at small strain.

namespace prosector {

struct LayerPress {
  double height, radius, depth, poisson_ratio, force;  // m, m, m, 1, N (converged, ± 0.1 %)
};
inline constexpr LayerPress layer_presses[] = {
    {0.02, 0.01, 0.001, 0.3, 0.02661}, {0.02, 0.01, 0.001, 0.45, 0.03128}, {0.02, 0.01, 0.001, 0.49, 0.03329},
    {0.05, 0.01, 0.001, 0.3, 0.02426}, {0.05, 0.01, 0.001, 0.45, 0.02795}, {0.05, 0.01, 0.001, 0.49, 0.02946},
    {0.05, 0.01, 0.002, 0.3, 0.06951}, {0.05, 0.01, 0.002, 0.45, 0.08041}, {0.05, 0.01, 0.002, 0.49, 0.08489},
};

}  // namespace prosector
