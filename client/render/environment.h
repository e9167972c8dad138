#pragma once
// Light from around, as passes take it. Private to client/render.

#include <vector>

#include "client/render/gl.h"
#include "common/math.h"

namespace prosector {

struct Environment {
  GLuint cube = 0;                          // the room, for mirrors
  std::vector<Eigen::Vector4f> irradiance;  // of irradiance_of(); empty: not known yet
};

}  // namespace prosector
