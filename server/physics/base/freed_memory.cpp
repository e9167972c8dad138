#include "server/physics/base/freed_memory.h"

#include <malloc.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace prosector {

void retain_freed_memory() {
#ifdef __GLIBC__
  constexpr int kept = 512 << 20, taken_alone = 32 << 20;  // bytes; the latter is the most that glibc allows
  mallopt(M_TRIM_THRESHOLD, kept);
  mallopt(M_MMAP_THRESHOLD, taken_alone);
#endif
}

void prefault_memory(std::size_t bytes) {
  constexpr std::size_t piece = 8 << 20, page = 4096;  // bytes; pieces, as larger ones aren't kept
  std::vector<std::unique_ptr<char[]>> taken;
  for (std::size_t begin = 0; begin < bytes; begin += piece) {
    const std::size_t size = std::min(piece, bytes - begin);
    taken.emplace_back(new char[size]);
    for (std::size_t at = 0; at < size; at += page) static_cast<volatile char*>(taken.back().get())[at] = 0;
  }
}

}  // namespace prosector
