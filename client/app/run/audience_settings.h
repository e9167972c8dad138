#pragma once
// Settings of the window for an audience.

#include "client/app/run/display_options.h"

namespace prosector {

/// Returns the settings of the window for spectators, which `o` must request. In stereo it shows one eye's
/// view with the aspect ratio of the stereo profile's display; with a headset, the left eye's view unchanged.
Audience audience_settings(const DisplayOptions& o);

}  // namespace prosector
