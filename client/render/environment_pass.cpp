#include "client/render/environment_pass.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "client/render/irradiance.h"
#include "client/render/main_uniforms.h"

namespace prosector {
namespace {

const Vec3 middle(0, 1.2, 0);  // m: centre of the room, at the height of objects on a table

/// Returns the cameras of the six faces, in OpenGL's order and row direction.
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

/// Returns the solid angle of a cube map's texel, sr; u and v run from −1 to 1 over its face.
double solid_angle(double u, double v, double width) {
  const double squared = 1 + u * u + v * v;
  return width * width / (squared * std::sqrt(squared));
}

}  // namespace

EnvironmentPass::EnvironmentPass(const Gl& gl, const std::filesystem::path& shaders)
    : gl_(gl), probe_(gl, shaders, {"PROBE"}) {
  gl_.GenTextures(1, &environment_.cube);
  gl_.BindTexture(GL_TEXTURE_CUBE_MAP, environment_.cube);
  for (GLenum face = 0; face < 6; ++face)
    gl_.TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGBA8, side, side, 0, GL_RGBA,
                   GL_UNSIGNED_BYTE, nullptr);
  gl_.TexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
  gl_.TexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    gl_.TexParameteri(GL_TEXTURE_CUBE_MAP, wrap, GL_CLAMP_TO_EDGE);
  gl_.Enable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
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
  gl_.DeleteTextures(1, &environment_.cube);
}

const Environment& EnvironmentPass::draw(const DrawList& list, const std::vector<QueuedItem>& items,
                                         const MeshCache& meshes) {
  const bool same_lights =
      std::equal(list.lights.begin(), list.lights.end(), lights_.begin(), lights_.end(), alike);
  if (list.ambient == ambient_ && same_lights) return environment_;
  ambient_ = list.ambient;
  lights_ = list.lights;
  std::vector<QueuedItem> room;
  for (const QueuedItem& queued : items)
    if (is_room(queued.item->appearance.surface)) room.push_back(queued);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl_.Disable(GL_SCISSOR_TEST);
  gl_.Viewport(0, 0, side, side);
  gl_.DepthMask(GL_TRUE);
  // Clears to ambient light for directions without room, encoded by encoded() of shaders/lighting.glsl.
  const Eigen::Vector3f around = (list.ambient / 4).cwiseSqrt().cast<float>();
  gl_.ClearColor(around.x(), around.y(), around.z(), 1);
  GLenum face = GL_TEXTURE_CUBE_MAP_POSITIVE_X;
  for (const DrawCamera& camera : face_cameras(side)) {
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, face++, environment_.cube, 0);
    gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    probe_.draw(list, camera, room, meshes, {}, {});
  }
  gl_.BindTexture(GL_TEXTURE_CUBE_MAP, environment_.cube);
  gl_.GenerateMipmap(GL_TEXTURE_CUBE_MAP);
  read_irradiance();
  return environment_;
}

void EnvironmentPass::read_irradiance() {
  constexpr int level = 2, coarse = side >> level;
  constexpr double width = 2.0 / coarse;
  std::vector<LightPatch> around;
  std::vector<std::uint8_t> texels(4 * coarse * coarse);
  GLenum face = GL_TEXTURE_CUBE_MAP_POSITIVE_X;
  for (const DrawCamera& camera : face_cameras(coarse)) {
    gl_.GetTexImage(face++, level, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    const std::uint8_t* texel = texels.data();
    for (int y = 0; y < coarse; ++y)
      for (int x = 0; x < coarse; ++x, texel += 4) {
        const double u = width * (x + 0.5) - 1, v = width * (y + 0.5) - 1;
        const Vec3 root = Vec3(texel[0], texel[1], texel[2]) / 255;
        around.push_back({camera.pose.q * Vec3(u, v, -1).normalized(), solid_angle(u, v, width),
                          4 * root.cwiseProduct(root)});
      }
  }
  environment_.irradiance.clear();
  for (const Vec3& x : irradiance_of(around))
    environment_.irradiance.emplace_back(static_cast<float>(x.x()), static_cast<float>(x.y()),
                                         static_cast<float>(x.z()), 0.0F);
}

}  // namespace prosector
