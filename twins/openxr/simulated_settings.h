#pragma once
// Settings of the simulated OpenXR runtime, from the environment variable PROSECTOR_OPENXR.

#include <limits>
#include <string>
#include <vector>

namespace prosector {

/// Time span of a simulated fault, s since the wearer's motion began. The motion begins with the first OpenXR
/// instance, or when the file named by `waits_for` exists.
struct Span {
  double begin = std::numeric_limits<double>::infinity(), end = begin;
  bool holds(double time) const { return time >= begin && time < end; }
};

struct SimulatedRuntimeSettings {
  std::string script;     // file of the wearer's motion; empty: no motion
  std::string waits_for;  // file that starts the motion once it exists; empty: starts immediately
  std::string pictures;   // folder for the images of both eyes, left.ppm and right.ppm; empty: none
  double rate = 60;       // frames per second
  int width = 320, height = 320;
  bool controllers = false;  // the hands hold controllers and are not tracked themselves
  bool held = false;         // the hands hold controllers and are tracked, too
  bool no_stage = false;     // the floor is unknown: no stage space
  bool glx = false;          // graphics through GLX instead of EGL
  Span unfocused, away, garbage;
  double session_lost = unfocused.begin, instance_lost = unfocused.begin, frame_refused = unfocused.begin,
         recentre_time = unfocused.begin, left = unfocused.begin;  // s
};

/// Reads the simulated runtime's settings from the environment variable PROSECTOR_OPENXR. Errors are reported
/// on standard error; the defaults are then used.
SimulatedRuntimeSettings simulated_runtime_settings();

}  // namespace prosector
