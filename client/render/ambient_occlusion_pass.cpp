#include "client/render/ambient_occlusion_pass.h"

namespace prosector {
namespace {

constexpr double radius = 0.05;  // m, radius of the sphere around a point

}  // namespace

AmbientOcclusionPass::AmbientOcclusionPass(const Gl& gl, const std::filesystem::path& shaders, int coarser)
    : gl_(gl),
      open_(gl, shaders, "ambient_occlusion", {"COARSER " + std::to_string(coarser)}),
      average_(gl, shaders, "ambient_occlusion_even", {"COARSER " + std::to_string(coarser)}),
      blend_(gl, shaders, "ambient_occlusion_blend", {"COARSER " + std::to_string(coarser)}),
      openness_(gl, coarser, GL_R8, GL_RED),
      evened_(gl, coarser, GL_R8, GL_RED) {
  gl_.GenVertexArrays(1, &no_vertices_);
}

AmbientOcclusionPass::~AmbientOcclusionPass() {
  gl_.DeleteVertexArrays(1, &no_vertices_);
}

void AmbientOcclusionPass::draw(const DrawList& list, RenderTarget& target) {
  const GLuint depth = target.depth();
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.BindVertexArray(no_vertices_);
  gl_.Disable(GL_DEPTH_TEST);
  openness_.begin(target.width(), target.height(), 1);
  gl_.BindTexture(GL_TEXTURE_2D, depth);
  for (const DrawCamera& camera : list.cameras)
    if (!camera.inset) draw_places(open_, camera);
  gl_.ActiveTexture(GL_TEXTURE1);
  evened_.begin(target.width(), target.height(), 1);
  gl_.BindTexture(GL_TEXTURE_2D, openness_.texture());
  for (const DrawCamera& camera : list.cameras)
    if (!camera.inset) draw_places(average_, camera);
  target.bind_again();
  gl_.BindTexture(GL_TEXTURE_2D, evened_.texture());
  gl_.Enable(GL_BLEND);
  gl_.BlendFunc(GL_ZERO, GL_SRC_COLOR);
  for (const DrawCamera& camera : list.cameras)
    if (!camera.inset) blend_over(camera);
  gl_.Disable(GL_BLEND);
}

void AmbientOcclusionPass::set_lens(const ShaderProgram& program, const DrawCamera& camera) const {
  program.set("scene_depth", 0);
  program.set("openness", 1);
  program.set("lens", std::vector<Eigen::Vector4f>{
                          Eigen::Vector4d(1 / camera.near, 1 / camera.far,
                                          camera.height / (camera.top - camera.bottom), radius)
                              .cast<float>()});
  program.set("viewport",
              std::vector<Eigen::Vector4f>{
                  Eigen::Vector4i(camera.x, camera.y, camera.width, camera.height).cast<float>()});
}

void AmbientOcclusionPass::draw_places(const ShaderProgram& program, const DrawCamera& camera) const {
  const Eigen::Vector4i viewport = openness_.viewport_of(camera);
  gl_.Viewport(viewport[0], viewport[1], viewport[2], viewport[3]);
  program.use();
  set_lens(program, camera);
  gl_.DrawArrays(GL_TRIANGLES, 0, 3);
}

void AmbientOcclusionPass::blend_over(const DrawCamera& camera) const {
  gl_.Viewport(camera.x, camera.y, camera.width, camera.height);
  blend_.use();
  set_lens(blend_, camera);
  gl_.DrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace prosector
