#pragma once
// Limits that a shell or a service manager sets for a process (`ulimit`, `LimitNOFILE=`).

namespace prosector {

/// Raises the soft limit on open files to the hard limit. Throws InputError if fewer than 64 files may be
/// open, or less than 1 GB of address space may be reserved. The DDS library terminates the process when
/// either runs out.
void check_process_limits();

}  // namespace prosector
