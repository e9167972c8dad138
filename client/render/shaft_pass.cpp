#include "client/render/shaft_pass.h"

#include <algorithm>
#include <cmath>

namespace prosector {
namespace {

constexpr int coarser = 4;      // ratio of the frame's size to the layer's
constexpr int cone_sides = 24;  // as in shaders/shaft.vert
constexpr double widest = 1.2;  // rad: wider cones have no beam
constexpr double reach = 3.0;   // m from the lamp

/// Returns whether the lamp has a narrow cone and a shadow map.
bool has_beam(const DrawList& list, const Shadow& shadow) {
  if (shadow.light < 0) return false;
  const LightInfo& lamp = list.lights[static_cast<std::size_t>(shadow.light)];
  return lamp.cone <= widest && lamp.intensity > 0;
}

}  // namespace

ShaftPass::ShaftPass(const Gl& gl, const std::filesystem::path& shaders)
    : gl_(gl),
      program_(gl, shaders, "shaft",
               {"CONE_SIDES " + std::to_string(cone_sides), "COARSER " + std::to_string(coarser)}),
      blend_(gl, shaders, "shaft_blend"),
      air_(gl, coarser, GL_RGBA8, GL_RGBA) {
  gl_.GenVertexArrays(1, &no_vertices_);
}

ShaftPass::~ShaftPass() {
  gl_.DeleteVertexArrays(1, &no_vertices_);
}

void ShaftPass::draw(const DrawList& list, const Shadow& shadow, RenderTarget& target) {
  if (!has_beam(list, shadow)) return;
  const GLuint depth = target.depth();
  gl_.BindVertexArray(no_vertices_);
  gl_.Disable(GL_DEPTH_TEST);
  air_.begin(target.width(), target.height(), 0);
  for (const DrawCamera& camera : list.cameras)
    if (!camera.inset) draw_air(list.lights[static_cast<std::size_t>(shadow.light)], camera, shadow, depth);
  target.bind_again();
  for (const DrawCamera& camera : list.cameras)
    if (!camera.inset) blend_over(camera);
}

void ShaftPass::draw_air(const LightInfo& lamp, const DrawCamera& camera, const Shadow& shadow,
                         GLuint depth) {
  const Eigen::Matrix4d clip_from_room = view_projection_of(camera);
  const Eigen::Vector4i viewport = air_.viewport_of(camera);
  gl_.Viewport(viewport[0], viewport[1], viewport[2], viewport[3]);
  program_.use();
  program_.set("clip_from_room", clip_from_room);
  program_.set("room_from_clip", Eigen::Matrix4d(clip_from_room.inverse()));
  program_.set("viewport", std::vector<Eigen::Vector4f>{viewport.cast<float>()});
  program_.set("eye", camera.pose.p);
  program_.set("lamp", lamp.position);
  program_.set("axis", Vec3(lamp.direction.normalized()));
  program_.set("cone", lamp.cone);
  program_.set("core", std::cos(lamp.cone * (1 - std::clamp(lamp.softness, 0.001, 1.0))));
  program_.set("reach", reach);
  program_.set("light", Vec3(lamp.intensity * lamp.color));
  program_.set("shadow_clip_from_room", shadow.clip_from_room);
  program_.set("shadow_size", shadow.size);
  program_.set("shadow_map", 0);
  program_.set("scene_depth", 1);
  gl_.ActiveTexture(GL_TEXTURE1);
  gl_.BindTexture(GL_TEXTURE_2D, depth);
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.BindTexture(GL_TEXTURE_2D, shadow.texture);
  // Draws the far side of the cone, which is visible even with the eye inside the beam.
  gl_.Enable(GL_CULL_FACE);
  gl_.CullFace(GL_FRONT);
  gl_.DrawArrays(GL_TRIANGLES, 0, 6 * cone_sides);
  gl_.CullFace(GL_BACK);
  gl_.Disable(GL_CULL_FACE);
}

void ShaftPass::blend_over(const DrawCamera& camera) {
  gl_.Viewport(camera.x, camera.y, camera.width, camera.height);
  blend_.use();
  blend_.set("air", 0);
  const Eigen::Vector2f pixels = air_.pixels().cast<float>();
  blend_.set("texel_from_pixel", std::vector<Eigen::Vector4f>{{1.0F / pixels.x(), 1.0F / pixels.y(), 0, 0}});
  gl_.BindTexture(GL_TEXTURE_2D, air_.texture());
  gl_.Enable(GL_BLEND);
  gl_.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_COLOR);
  gl_.DrawArrays(GL_TRIANGLES, 0, 3);
  gl_.Disable(GL_BLEND);
}

}  // namespace prosector
