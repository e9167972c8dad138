#pragma once
// Set-up window: shows pages until the user enters a session, runs the session as a separate process, and
// shows the pages again.

#include "client/app/run/options.h"

namespace prosector {

/// Shows the set-up window until the user closes it, and returns the program's exit code. Throws InputError
/// if no window can be opened.
int run_setup(const SetupOptions& options);

}  // namespace prosector
