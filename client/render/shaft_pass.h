#pragma once
// Light scattered by dust in the beam of the shadow-casting lamp, added over the lit surfaces. Computed for
// one pixel in sixteen, because light in air has no sharp edges.
// Private to client/render.

#include "client/render/low_res_layer.h"
#include "client/render/render_target.h"
#include "client/render/shadow_pass.h"

namespace prosector {

class ShaftPass {
 public:
  ShaftPass(const Gl& gl, const std::filesystem::path& shaders);
  ~ShaftPass();
  ShaftPass(const ShaftPass&) = delete;
  ShaftPass& operator=(const ShaftPass&) = delete;

  /// Adds the light that dust scatters in the lamp's beam to `target`, which must already contain the
  /// surfaces and their depth.
  void draw(const DrawList& list, const Shadow& shadow, RenderTarget& target);

 private:
  const Gl& gl_;
  ShaderProgram program_;
  ShaderProgram blend_;
  LowResLayer air_;
  GLuint no_vertices_ = 0;

  void draw_air(const LightInfo& lamp, const DrawCamera& camera, const Shadow& shadow, GLuint depth);
  void blend_over(const DrawCamera& camera);
};

}  // namespace prosector
