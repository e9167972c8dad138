#pragma once
// Refraction of glass. Private to client/render.

#include "client/render/gl.h"
#include "common/appearance.h"
#include "common/math.h"

namespace prosector {

/// Inputs for drawing a layer of glass: the frame so far, its depth, and the layer's faces. The textures have
/// the frame's size.
struct Refraction {
  GLuint picture = 0, scene_depth = 0, front_depth = 0, back_depth = 0, back_normals = 0;
};

/// Returns the refractive indices at the dominant wavelengths of sRGB's red, green and blue. Cauchy's
/// equation n = A + B/λ² is fitted to n_d and the Abbe number V_d (Born & Wolf, Principles of Optics, 7th ed.
/// 1999, 4.7).
Vec3 refractive_indices(const Appearance& glass);

}  // namespace prosector
