#pragma once
// A stereo display with two views side by side, described by a file in deploy/stereo.

#include <string>
#include <string_view>
#include <vector>

#include "common/eye_distance.h"

namespace prosector {

/// Properties of a head-mounted or other stereo display that takes two views side by side: size, field of
/// view, eye distance and convergence. The table in stereo_profile.cpp holds their ranges. Files give angles
/// in degrees.
struct StereoProfile {
  std::string description;
  double eye_width = 800, eye_height = 600;               // pixels, each eye
  double fov_horizontal = 0.70;                           // rad, each eye
  double fov_vertical = 0.54;                             // rad
  double eye_distance = default_interpupillary_distance;  // m
  double convergence = 0.6;                               // m: distance at which both views coincide
  bool swap_eyes = false;                                 // true: the left eye's view is on the right

  int picture_width() const { return 2 * static_cast<int>(eye_width); }
  int picture_height() const { return static_cast<int>(eye_height); }
};

/// Parses the TOML text of a stereo display's profile. `file` is its name, for errors. Throws InputError with
/// file, line, key and allowed values; unknown keys are errors.
StereoProfile parse_stereo_profile(std::string_view toml, const std::string& file);

/// Loads the profile of a stereo display. `profile` is a file, or the name of a shipped profile
/// ("5dt_hmd_800_26"). Throws InputError if its text is invalid, or, with the list of shipped profiles, if
/// there is no such profile.
StereoProfile load_stereo_profile(const std::string& profile);

/// Returns the names of the stereo-display profiles that are shipped with the program, sorted.
std::vector<std::string> shipped_profiles();

}  // namespace prosector
