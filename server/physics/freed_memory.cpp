#include "server/physics/freed_memory.h"

#include <malloc.h>

namespace prosector {

void keep_freed_memory() {
#ifdef __GLIBC__
  constexpr int kept = 512 << 20, taken_alone = 32 << 20;  // bytes; the latter is the most that glibc allows
  mallopt(M_TRIM_THRESHOLD, kept);
  mallopt(M_MMAP_THRESHOLD, taken_alone);
#endif
}

}  // namespace prosector
