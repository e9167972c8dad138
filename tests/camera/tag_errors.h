#pragma once
// How far off boards are found, over many places before a synthetic camera.

#include <vector>

#include "drivers/camera/tags/edge_fit.h"
#include "tests/camera/tag_cases.h"

namespace prosector {

struct TagCase {
  Board board;
  double distance = 0.6;                   // m
  double least_tilt = 0, most_tilt = 0.9;  // rad
  double covered = 0;                      // share of the board's width that a hand-like plate hides
  double response = 2.2;                   // the camera's
  double assumed = default_response;
  double exposure = 0, speed = 0;  // s; m/s across the picture
  double noise = 3;                // of 255
  TagDetectorSettings finder = {};
  double light = 1;       // that falls in
  bool reads_on = false;  // pictures are read as trackers read them, and the third one counts
  int width = 640, height = 480;
  bool still = false;  // one place, seen again and again: errors are about their mean
  int places = 12;
};

struct TagErrors {
  std::vector<double> depth, lateral;  // mm
  std::vector<double> turn;            // rad
  std::vector<double> told;            // mm: the standard deviation of depth that the fit tells
  std::vector<double> straighten_ms, find_ms, fit_ms;  // of a picture, on one thread
  int seen = 0;
};

TagErrors tag_errors(const TagCase& what);
/// Returns the value that a share of them doesn't exceed; infinity of none.
double quantile(std::vector<double> values, double share);

}  // namespace prosector
