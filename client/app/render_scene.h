#pragma once
// prosector-client render: pictures of a scene file, without a session.

#include <filesystem>
#include <string>

#include "client/render/renderer.h"

namespace prosector {

struct RenderOptions {
  std::filesystem::path scene, out, shaders;
  int width = 640, height = 480;
  QualityLevel quality = quality_levels[1];
  bool osmesa = false;   // else EGL surfaceless where there is one
  std::string view;      // only this one; empty: all
  bool compare = false;  // also each effect the other way, where it shows
  bool sheet = false;    // also all pictures on one, SCENE-sheet.png
  double turntable = 0;  // s of a video of one turn around the scene, SCENE-turn.avi; 0: none
};

/// Writes OUT/SCENE-VIEW.png, and with `compare` OUT/SCENE-without-EFFECT.png (or -with-). Returns the exit
/// code; throws InputError as the server would for a scene, and where a folder or file cannot be written.
int render_scene(const RenderOptions& options);

}  // namespace prosector
