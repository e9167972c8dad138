#pragma once
// The set-up window's life: pages until somebody goes into a session, the session as a program of its own,
// and the pages again.

#include "client/app/options.h"

namespace prosector {

/// Runs the set-up window and returns the exit code. Throws InputError where there is no window.
int run_setup(const SetupOptions& options);

}  // namespace prosector
