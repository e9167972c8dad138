#pragma once
// Dust in the beam of the lamp that casts shadows: what it sends to the eye, added over the lit surfaces.
// Reckoned for one pixel in sixteen: air has no edges of its own.
// Private to client/render.

#include "client/render/coarse_layer.h"
#include "client/render/render_target.h"
#include "client/render/shadow_pass.h"

namespace prosector {

class ShaftPass {
 public:
  ShaftPass(const Gl& gl, const std::filesystem::path& shaders);
  ~ShaftPass();
  ShaftPass(const ShaftPass&) = delete;
  ShaftPass& operator=(const ShaftPass&) = delete;

  /// Draws into `target`, which holds the surfaces already.
  void draw(const DrawList& list, const Shadow& shadow, RenderTarget& target);

 private:
  const Gl& gl_;
  ShaderProgram program_;
  ShaderProgram blend_;
  CoarseLayer air_;
  GLuint no_vertices_ = 0;

  void draw_air(const LightInfo& lamp, const DrawCamera& camera, const Shadow& shadow, GLuint depth);
  void lay_over(const DrawCamera& camera);
};

}  // namespace prosector
