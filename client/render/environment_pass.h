#pragma once
// Environment map: the room from its centre as a cube map with rougher mip levels for reflections, and its
// irradiance on surfaces. Redrawn only when the lights change. Private to client/render.

#include "client/render/main_pass.h"

namespace prosector {

class EnvironmentPass {
 public:
  EnvironmentPass(const Gl& gl, const std::filesystem::path& shaders);
  ~EnvironmentPass();
  EnvironmentPass(const EnvironmentPass&) = delete;
  EnvironmentPass& operator=(const EnvironmentPass&) = delete;

  /// Redraws the environment map if the lights changed since the last call. Returns the map of reflections
  /// and the irradiance. See encoded() in shaders/lighting.glsl for how texels hold radiance.
  const Environment& draw(const DrawList& list, const std::vector<QueuedItem>& items,
                          const MeshCache& meshes);

 private:
  static constexpr int side = 64;  // texels; six halvings to the roughest level

  void read_irradiance();

  const Gl& gl_;
  MainPass probe_;
  Environment environment_;
  GLuint framebuffer_ = 0, depth_ = 0;
  std::vector<LightInfo> lights_;  // the lights that the map was drawn with
  Vec3 ambient_ = Vec3::Constant(-1);
};

}  // namespace prosector
