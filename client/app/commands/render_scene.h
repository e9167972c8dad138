#pragma once
// `prosector-client render`: images of a scene file, without a session.

#include <filesystem>
#include <string>

#include "client/render/renderer.h"

namespace prosector {

struct RenderOptions {
  std::filesystem::path scene, out, shaders;
  int width = 640, height = 480;
  QualityLevel quality = quality_levels[1];
  bool osmesa = false;   // use OSMesa; else EGL surfaceless if available
  std::string view;      // render only this view; empty: all
  bool compare = false;  // also render with each effect toggled, in a view that shows it
  bool sheet = false;    // also write a contact sheet of all images, SCENE-sheet.png
  double turntable = 0;  // s, duration of a video of one turn around the scene, SCENE-turn.avi; 0: none
};

/// Renders images of a scene file without a session, and writes them as OUT/SCENE-VIEW.png. With `compare`,
/// also writes OUT/SCENE-without-EFFECT.png (or -with-). Returns the program's exit code. Throws InputError
/// for scenes that the server rejects, and if a folder or file cannot be written.
int render_scene(const RenderOptions& options);

}  // namespace prosector
