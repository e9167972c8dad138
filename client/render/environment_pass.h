#pragma once
// What a mirror sees: the room's walls and floor from its middle, as a cube map with rougher levels. Drawn
// anew only when its lights change. Private to client/render.

#include "client/render/main_pass.h"

namespace prosector {

class EnvironmentPass {
 public:
  EnvironmentPass(const Gl& gl, const std::filesystem::path& shaders);
  ~EnvironmentPass();
  EnvironmentPass(const EnvironmentPass&) = delete;
  EnvironmentPass& operator=(const EnvironmentPass&) = delete;

  /// Draws and returns the cube map's texture; shaders/lighting.glsl tells how its texels hold radiance.
  GLuint draw(const DrawList& list, const std::vector<QueuedItem>& items, const MeshCache& meshes);

 private:
  static constexpr int side = 64;  // texels; six halvings to the roughest level

  const Gl& gl_;
  MainPass probe_;
  GLuint framebuffer_ = 0, cube_ = 0, depth_ = 0;
  std::vector<LightInfo> lights_;  // that it was drawn under
  Vec3 ambient_ = Vec3::Constant(-1);
};

}  // namespace prosector
