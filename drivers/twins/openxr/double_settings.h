#pragma once
// What the simulated OpenXR runtime is told: the words in the environment's PROSECTOR_OPENXR.

#include <limits>
#include <string>
#include <vector>

namespace prosector {

/// A time, s after the first instance was made, or after the wearer goes on.
struct Span {
  double begin = std::numeric_limits<double>::infinity(), end = begin;
  bool holds(double time) const { return time >= begin && time < end; }
};

struct DoubleSettings {
  std::string script;     // of the wearer's motion; empty: they stand still
  std::string waits_for;  // a file without which time stands still; empty: it goes on at once
  std::string pictures;   // folder for both eyes' pictures, left.ppm and right.ppm; empty: none
  double rate = 60;       // frames a second
  int width = 320, height = 320;
  bool controllers = false;  // in the hands, which are not seen by themselves
  bool held = false;         // controllers in hands that are seen, too
  bool no_stage = false;     // it doesn't know the floor
  bool glx = false;          // it takes pictures by GLX, and not by EGL
  Span unfocused, away, garbage;
  double session_lost = unfocused.begin, instance_lost = unfocused.begin, frame_refused = unfocused.begin,
         centred_anew = unfocused.begin, left = unfocused.begin;  // s
};

/// Reads the settings; wrong ones are told on standard error, and none hold.
DoubleSettings settings_of_double();

}  // namespace prosector
