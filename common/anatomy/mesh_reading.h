#pragma once
// How a mesh file is read, beside its scale.

#include "common/anatomy/progress.h"
#include "common/math.h"

namespace prosector {

struct MeshReading {
  Vec3 origin = Vec3::Zero();  // point of the file, in its units, that becomes the mesh's origin
  Progress report = {};  // what was repaired, or is not used; lines that begin with "warning: " are warnings
  double patience = 60;  // s: surfaces only
};

}  // namespace prosector
