#pragma once
// Retention of freed memory in the process.

#include <cstddef>

namespace prosector {

/// Keeps freed memory with the process from here on, up to 512 MB, instead of giving it back to the system. A
/// cut frees and takes megabytes, and pages that come from the system cost more than what is written to them.
/// For programs that simulate, at their start; without effect where the C library can't.
void retain_freed_memory();

/// Takes that much memory, writes to each of its pages and frees it, for what the thread takes later. Where
/// freed memory is kept, that finds pages that are there. To get them from the system took three quarters of
/// a tick in which a body was refined.
void prefault_memory(std::size_t bytes);

}  // namespace prosector
