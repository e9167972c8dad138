#pragma once
// One picture of a camera.

#include <cstdint>

#include "common/image.h"

namespace prosector {

struct Frame {
  Image image;
  std::int64_t time_ns = 0;  // monotonic_ns() in the middle of its exposure, as well as it is known
  std::uint64_t number = 0;  // counts this camera's pictures from 0; what was dropped is counted, too
};

}  // namespace prosector
