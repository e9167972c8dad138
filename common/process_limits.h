#pragma once
// Limits that a shell or a service manager sets for a process (`ulimit`, `LimitNOFILE=`).

namespace prosector {

/// Raises the number of files that this process may have open to what its hard limit permits. Throws
/// InputError if fewer than 64 files may be open, or less than 1 GB of addresses may be reserved: the
/// network's library ends the process where either runs out.
void check_process_limits();

}  // namespace prosector
