#pragma once
// A face of ours before a synthetic camera at a screen: how far off is the way from the eyes to the screen's
// middle, which a window into the room is drawn by?

#include <filesystem>
#include <memory>
#include <vector>

#include "drivers/camera/face/face_detector.h"
#include "twins/camera/face_mesh.h"

namespace prosector {

struct FaceCase {
  double distance = 0.6;  // m from the screen
  double aside = 0;       // m, to the screen's right
  double yaw = 0;         // rad, the face turned to the screen's right
  double speed = 0;       // m/s to the screen's right
  double light = 1;       // share of the usual
  int height = 480;       // lines of a picture of 4:3
  int places = 6;         // around that one
  int pictures = 10;      // of each place, 30 a second
};

struct FaceErrors {
  int pictures = 0, seen = 0;
  // Of the last picture of each place, smoothed.
  std::vector<double> gaze;    // rad, of the way to the screen's middle
  std::vector<double> depth;   // mm, along that way
  std::vector<double> across;  // mm
  std::vector<double> lag;     // s, of what moves: by how much what is told is behind
  // Of each picture.
  std::vector<double> find_ms, smooth_ms;
  double jitter_across = 0, jitter_along = 0;  // mm, RMS from picture to picture, of what isn't smoothed yet
  double rest_across = 0, rest_along = 0;      // mm, RMS from picture to picture, smoothed
};

/// Measures. `models`: folder of the networks; the face is the mesh's.
FaceErrors face_errors(const FaceCase& what, const std::shared_ptr<const FaceMesh>& face,
                       const std::filesystem::path& models);

}  // namespace prosector
