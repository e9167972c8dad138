#pragma once
// What a process does with memory that it freed.

namespace prosector {

/// Keeps freed memory with the process from here on, up to 512 MB, instead of giving it back to the system. A
/// cut frees and takes megabytes, and pages that come from the system cost more than what is written to them.
/// For programs that simulate, at their start; without effect where the C library can't.
void keep_freed_memory();

}  // namespace prosector
