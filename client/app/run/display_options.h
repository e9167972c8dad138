#pragma once
// Options of the display: its kind, size, monitors and frame rate.

#include <cstdint>
#include <optional>

#include "client/render/window_context.h"
#include "client/view/stereo_profile.h"

namespace prosector {

enum class Display : std::uint8_t { window, stereo, openxr, offscreen, osmesa, none };

struct DisplayOptions {
  Display kind = Display::window;
  StereoProfile stereo;  // used with Display::stereo
  int width = 800, height = 600;
  std::optional<int> monitor;        // index of the monitor for full screen, from 0; nullopt: a window
  std::optional<Audience> audience;  // second window for an audience; nullopt: none
  std::optional<double> scale;       // scale of overlays; nullopt: the desktop's, else 1
  double frames_per_second = 30;
};

}  // namespace prosector
