#pragma once
// Options for reading a mesh file, in addition to its scale.

#include "common/anatomy/progress.h"
#include "common/math.h"

namespace prosector {

struct MeshReadOptions {
  Vec3 origin = Vec3::Zero();  // file units: point of the file that becomes the mesh's origin
  Progress report = {};        // repairs and unused content; lines that begin with "warning: " are warnings
  double time_limit = 60;      // s: time limit; surfaces only
};

}  // namespace prosector
