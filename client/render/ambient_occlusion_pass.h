#pragma once
// Screen-space ambient occlusion, computed from the depth buffer: ambient light that does not reach creases
// and contacts. Computes the filled fraction of a sphere around each point (Loos and Sloan, Volumetric
// obscurance, I3D 2010). Sample lines through the sphere come in pairs, one on each side of its centre, whose
// sum is zero on any plane. Private to client/render.

#include "client/render/low_res_layer.h"
#include "client/render/render_target.h"

namespace prosector {

class AmbientOcclusionPass {
 public:
  /// Compiles the shaders of the pass. Occlusion is computed with one sample per block of `coarser` ×
  /// `coarser` pixels of the frame.
  AmbientOcclusionPass(const Gl& gl, const std::filesystem::path& shaders, int coarser);
  ~AmbientOcclusionPass();
  AmbientOcclusionPass(const AmbientOcclusionPass&) = delete;
  AmbientOcclusionPass& operator=(const AmbientOcclusionPass&) = delete;

  /// Darkens creases and contacts in `target`, which must already contain the list's opaque surfaces and
  /// their depth.
  void draw(const DrawList& list, RenderTarget& target);

 private:
  const Gl& gl_;
  ShaderProgram open_;     // openness of each sample
  ShaderProgram average_;  // average over neighbours
  ShaderProgram blend_;    // applies the result to pixels
  LowResLayer openness_, evened_;
  GLuint no_vertices_ = 0;

  void set_lens(const ShaderProgram& program, const DrawCamera& camera) const;
  void draw_places(const ShaderProgram& program, const DrawCamera& camera) const;
  void blend_over(const DrawCamera& camera) const;
};

}  // namespace prosector
