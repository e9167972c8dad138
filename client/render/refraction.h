#pragma once
// Refraction of glass. Private to client/render.

#include "client/render/gl.h"
#include "common/appearance.h"
#include "common/math.h"

namespace prosector {

/// Input textures for drawing a layer of glass, all of the frame's size. They hold colour and depth of the
/// frame so far, depth of the glass's front and back faces, and normals of its back faces.
struct Refraction {
  GLuint picture = 0, scene_depth = 0, front_depth = 0, back_depth = 0, back_normals = 0;
};

/// Returns the refractive indices of the glass at the dominant wavelengths of sRGB's red, green and blue.
/// They follow Cauchy's equation n = A + B/λ², fitted to the appearance's n_d and Abbe number V_d (Born &
/// Wolf, Principles of Optics, 7th ed. 1999, 4.7).
Vec3 refractive_indices(const Appearance& glass);

}  // namespace prosector
