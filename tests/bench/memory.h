#pragma once
// How much memory things take.

#include <malloc.h>

#include <cstddef>

namespace prosector {

/// Bytes that the program holds from malloc at this moment.
inline std::size_t allocated_bytes() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

}  // namespace prosector
