#pragma once
// A stereo display with two views side by side, described by a file in deploy/stereo.

#include <string>
#include <string_view>
#include <vector>

#include "common/eye_distance.h"

namespace prosector {

/// A head-mounted or other stereo display. The table in stereo_profile.cpp holds the ranges. Files give
/// angles in degrees.
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

/// Reads a profile. Throws InputError with file, line, key and allowed values; unknown keys are errors.
StereoProfile parse_stereo_profile(std::string_view toml, const std::string& file);

/// Loads `profile`: a file, or the name of a shipped profile ("5dt_hmd_800_26"). Throws InputError as
/// parse_stereo_profile() does, or with the list of shipped profiles.
StereoProfile load_stereo_profile(const std::string& profile);

/// Returns the names of the shipped profiles, sorted.
std::vector<std::string> shipped_profiles();

}  // namespace prosector
