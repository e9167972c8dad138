#pragma once
// Settings of the window for an audience.

#include "client/app/run/options.h"

namespace prosector {

/// Returns the audience window's settings; `o` must request one. In stereo it shows one eye with the aspect
/// ratio of the profile's display; with a headset, the left eye unchanged.
Audience audience_settings(const ClientOptions& o);

}  // namespace prosector
