#pragma once
// Options of augmented reality over a camera's images.

#include <string>
#include <vector>

namespace prosector {

struct ArOptions {
  std::string camera;                 // address; empty: no augmented reality
  std::vector<std::string> phantoms;  // names of bodies that are physically present in front of the camera
};

}  // namespace prosector
