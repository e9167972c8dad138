#pragma once
// Environment lighting, as input of passes. Private to client/render.

#include <vector>

#include "client/render/gl.h"
#include "common/math.h"

namespace prosector {

struct Environment {
  GLuint cube = 0;                          // cube map of the room, for reflections
  std::vector<Eigen::Vector4f> irradiance;  // from irradiance_of(); empty: unknown yet
};

}  // namespace prosector
