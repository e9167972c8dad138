#pragma once
// Settings of a face tracker beyond its camera.

#include "common/eye_distance.h"

namespace prosector {

struct FaceTrackingConfig {
  double eye_distance = default_interpupillary_distance;  // m, interpupillary distance; depth scales with it
};

}  // namespace prosector
