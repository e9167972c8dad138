#pragma once
// Retention of freed memory in the process.

#include <cstddef>

namespace prosector {

/// Makes the process retain freed memory from now on, up to 512 MB, instead of returning it to the system. A
/// cut frees and allocates megabytes, and pages that come from the system cost more than what is written to
/// them. Simulation programs call it at their start. Without effect where the C library does not support it.
void retain_freed_memory();

/// Allocates `bytes` bytes, writes to each of their pages and frees them, so that later allocations of the
/// thread find pages that are already present. This works if freed memory is retained by
/// retain_freed_memory(). Getting the pages from the system took three quarters of a tick in which a body was
/// refined.
void prefault_memory(std::size_t bytes);

}  // namespace prosector
