#pragma once
// What light does at glass. Private to client/render.

#include "client/render/gl.h"
#include "common/messages.h"

namespace prosector {

/// What a layer of glass lets through: the picture so far, its depth, and the layer's own faces; textures as
/// large as the picture.
struct Refraction {
  GLuint picture = 0, scene_depth = 0, front_depth = 0, back_depth = 0, back_normals = 0;
};

/// Returns the index of refraction for the wavelengths that sRGB's red, green and blue look like. It follows
/// Cauchy's n = A + B/λ² through n_d with the dispersion of V_d (Born & Wolf, Principles of Optics, 7th ed.
/// 1999, 4.7).
Vec3 refractive_indices(const Appearance& glass);

}  // namespace prosector
