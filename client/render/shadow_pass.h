#pragma once
// Depth of the scene as the first spot light sees it. Private to client/render.

#include <filesystem>
#include <vector>

#include "client/render/draw_queue.h"
#include "client/render/shader_program.h"

namespace prosector {

/// What the main pass needs of a shadow map.
struct Shadow {
  int light = -1;  // index into DrawList::lights; −1: no shadows
  Eigen::Matrix4d clip_from_room = Eigen::Matrix4d::Identity();
  GLuint texture = 0;
  double size = 0;   // texels, each way
  double texel = 0;  // width of a texel at 1 m from the light, m
};

class ShadowPass {
 public:
  ShadowPass(const Gl& gl, const std::filesystem::path& shaders, int size);
  ~ShadowPass();
  ShadowPass(const ShadowPass&) = delete;
  ShadowPass& operator=(const ShadowPass&) = delete;

  Shadow draw(const DrawList& list, const std::vector<QueuedItem>& items, const MeshCache& meshes);

 private:
  const Gl& gl_;
  ShaderProgram program_;
  int size_;
  GLuint framebuffer_ = 0, depth_ = 0;
};

}  // namespace prosector
