#pragma once
// What is around: the room from its middle, as a cube map with rougher levels for what mirrors it, and as the
// light that it sends to surfaces. Drawn anew only when its lights change. Private to client/render.

#include "client/render/main_pass.h"

namespace prosector {

class EnvironmentPass {
 public:
  EnvironmentPass(const Gl& gl, const std::filesystem::path& shaders);
  ~EnvironmentPass();
  EnvironmentPass(const EnvironmentPass&) = delete;
  EnvironmentPass& operator=(const EnvironmentPass&) = delete;

  /// Draws the room as far as that is due; shaders/lighting.glsl tells how the cube's texels hold radiance.
  const Environment& draw(const DrawList& list, const std::vector<QueuedItem>& items,
                          const MeshCache& meshes);

 private:
  static constexpr int side = 64;  // texels; six halvings to the roughest level

  void read_irradiance();

  const Gl& gl_;
  MainPass probe_;
  Environment environment_;
  GLuint framebuffer_ = 0, depth_ = 0;
  std::vector<LightInfo> lights_;  // that it was drawn under
  Vec3 ambient_ = Vec3::Constant(-1);
};

}  // namespace prosector
