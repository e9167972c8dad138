#pragma once
// One image of a camera.

#include <cstdint>

#include "common/image.h"

namespace prosector {

struct Frame {
  Image image;
  std::int64_t time_ns = 0;  // monotonic_ns() at mid-exposure, as exactly as it is known
  std::uint64_t number = 0;  // index of the image, from 0; dropped images are counted
};

}  // namespace prosector
