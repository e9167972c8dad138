#pragma once
// Light from around that does not get into creases and between things that touch, found in the picture's
// depth. It asks how much of a ball around a point is filled (Loos and Sloan, Volumetric obscurance, I3D
// 2010). Lines through the ball come in pairs, one on each side of its middle, whose sum is nothing on any
// plane. Private to client/render.

#include "client/render/coarse_layer.h"
#include "client/render/render_target.h"

namespace prosector {

class AmbientOcclusionPass {
 public:
  /// Reckons for one place in `coarser` × `coarser` pixels.
  AmbientOcclusionPass(const Gl& gl, const std::filesystem::path& shaders, int coarser);
  ~AmbientOcclusionPass();
  AmbientOcclusionPass(const AmbientOcclusionPass&) = delete;
  AmbientOcclusionPass& operator=(const AmbientOcclusionPass&) = delete;

  /// Darkens `target`, which holds the surfaces already.
  void draw(const DrawList& list, RenderTarget& target);

 private:
  const Gl& gl_;
  ShaderProgram open_;   // how open each place is, by lines of its own
  ShaderProgram even_;   // the mean of neighbours
  ShaderProgram blend_;  // onto pixels
  CoarseLayer openness_, evened_;
  GLuint no_vertices_ = 0;

  void set_lens(const ShaderProgram& program, const DrawCamera& camera) const;
  void draw_places(const ShaderProgram& program, const DrawCamera& camera) const;
  void lay_over(const DrawCamera& camera) const;
};

}  // namespace prosector
