#pragma once
// Memory use of the program.

#include <malloc.h>

#include <cstddef>

namespace prosector {

/// Returns the bytes currently allocated with malloc.
inline std::size_t allocated_bytes() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

}  // namespace prosector
