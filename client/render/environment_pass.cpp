#include "client/render/environment_pass.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace prosector {
namespace {

const Vec3 middle(0, 1.2, 0);  // m: of the room, as high as what lies on a table

/// Returns what looks through the six faces, in OpenGL's order and with its rows.
std::array<DrawCamera, 6> face_cameras(int side) {
  const std::array<std::array<Vec3, 2>, 6> ahead_and_up = {{{Vec3::UnitX(), -Vec3::UnitY()},
                                                            {-Vec3::UnitX(), -Vec3::UnitY()},
                                                            {Vec3::UnitY(), Vec3::UnitZ()},
                                                            {-Vec3::UnitY(), -Vec3::UnitZ()},
                                                            {Vec3::UnitZ(), -Vec3::UnitY()},
                                                            {-Vec3::UnitZ(), -Vec3::UnitY()}}};
  std::array<DrawCamera, 6> out;
  for (std::size_t k = 0; k < 6; ++k) {
    const auto& [ahead, up] = ahead_and_up[k];
    Mat3 axes;
    axes << ahead.cross(up), up, -ahead;
    out[k].pose = {middle, Quat(axes)};
    out[k].left = out[k].bottom = -1;
    out[k].right = out[k].top = 1;
    out[k].width = out[k].height = side;
  }
  return out;
}

bool alike(const LightInfo& a, const LightInfo& b) {
  return a.kind == b.kind && a.position == b.position && a.direction == b.direction && a.color == b.color &&
         a.intensity == b.intensity && a.cone == b.cone && a.softness == b.softness;
}

bool is_room(const QueuedItem& queued) {
  const Surface surface = queued.item->appearance.surface;
  return surface == Surface::floor || surface == Surface::wall;
}

}  // namespace

EnvironmentPass::EnvironmentPass(const Gl& gl, const std::filesystem::path& shaders)
    : gl_(gl), probe_(gl, shaders, {"PROBE"}) {
  gl_.GenTextures(1, &cube_);
  gl_.BindTexture(GL_TEXTURE_CUBE_MAP, cube_);
  for (GLenum face = 0; face < 6; ++face)
    gl_.TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGBA8, side, side, 0, GL_RGBA,
                   GL_UNSIGNED_BYTE, nullptr);
  gl_.TexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
  gl_.TexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    gl_.TexParameteri(GL_TEXTURE_CUBE_MAP, wrap, GL_CLAMP_TO_EDGE);
  gl_.GenRenderbuffers(1, &depth_);
  gl_.BindRenderbuffer(GL_RENDERBUFFER, depth_);
  gl_.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, side, side);
  gl_.GenFramebuffers(1, &framebuffer_);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
}

EnvironmentPass::~EnvironmentPass() {
  gl_.DeleteFramebuffers(1, &framebuffer_);
  gl_.DeleteRenderbuffers(1, &depth_);
  gl_.DeleteTextures(1, &cube_);
}

GLuint EnvironmentPass::draw(const DrawList& list, const std::vector<QueuedItem>& items,
                             const MeshCache& meshes) {
  const bool same_lights =
      std::equal(list.lights.begin(), list.lights.end(), lights_.begin(), lights_.end(), alike);
  if (list.ambient == ambient_ && same_lights) return cube_;
  ambient_ = list.ambient;
  lights_ = list.lights;
  std::vector<QueuedItem> room;
  for (const QueuedItem& queued : items)
    if (is_room(queued)) room.push_back(queued);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl_.Disable(GL_SCISSOR_TEST);
  gl_.Viewport(0, 0, side, side);
  gl_.DepthMask(GL_TRUE);
  // Where there is no wall, a bright ceiling (as in surroundings() of shaders/lighting.glsl), encoded as the
  // shader does.
  const Eigen::Vector3f ceiling = (1.9 * list.ambient / 4).cwiseSqrt().cast<float>();
  gl_.ClearColor(ceiling.x(), ceiling.y(), ceiling.z(), 1);
  GLenum face = GL_TEXTURE_CUBE_MAP_POSITIVE_X;
  for (const DrawCamera& camera : face_cameras(side)) {
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, face++, cube_, 0);
    gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    probe_.draw(list, camera, room, meshes, {});
  }
  gl_.BindTexture(GL_TEXTURE_CUBE_MAP, cube_);
  gl_.GenerateMipmap(GL_TEXTURE_CUBE_MAP);
  return cube_;
}

}  // namespace prosector
