#include "client/render/main_pass.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace prosector {
namespace {

// The order of Surface.
constexpr std::array<const char*, 9> surface_defines = {
    "SURFACE_PLAIN", "SURFACE_TISSUE", "SURFACE_BONE", "SURFACE_METAL",   "SURFACE_SKIN",
    "SURFACE_CLOTH", "SURFACE_FLOOR",  "SURFACE_WALL", "SURFACE_EMISSIVE"};

Eigen::Vector4f vec4(const Vec3& v, double w) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z()),
          static_cast<float>(w)};
}

/// Lights as the shader's arrays; w holds the cosine of the cone and that of its bright core.
void set_lights(const ShaderProgram& program, const std::vector<LightInfo>& lights) {
  const std::size_t count = std::min(lights.size(), max_lights);
  std::vector<Eigen::Vector4f> position, direction, color;
  for (std::size_t k = 0; k < count; ++k) {
    const LightInfo& light = lights[k];
    const double core = light.cone * (1 - std::clamp(light.softness, 0.001, 1.0));
    position.push_back(vec4(light.position, 1));
    direction.push_back(vec4(light.direction.normalized(), std::cos(light.cone)));
    color.push_back(vec4(light.intensity * light.color, std::cos(core)));
  }
  program.set("light_position", position);
  program.set("light_direction", direction);
  program.set("light_color", color);
}

void set_frame(const ShaderProgram& program, const DrawList& list, const DrawCamera& camera,
               const Shadow& shadow) {
  program.set("clip_from_room", view_projection_of(camera));
  program.set("eye", camera.pose.p);
  program.set("ambient", list.ambient);
  program.set("shadow_map", 0);
  program.set("shadow_clip_from_room", shadow.clip_from_room);
  program.set("shadow_texel", shadow.texel);
  set_lights(program, list.lights);
}

void set_item(const ShaderProgram& program, const DrawItem& item) {
  program.set("room_from_mesh", matrix_of(item.pose));
  program.set("base_color", item.appearance.color);
  program.set("base_roughness", item.appearance.roughness);
  program.set("wetness", item.appearance.wetness);
}

/// Which lights there are, as the macro that lighting.glsl unrolls its sum with.
std::string lights_define(const std::vector<LightInfo>& lights, int shadow_light) {
  std::string text = "EACH_LIGHT(DO)";
  for (std::size_t k = 0; k < std::min(lights.size(), max_lights); ++k)
    text += fmt::format(" DO({}, {}, {})", k, static_cast<int>(lights[k].kind),
                        static_cast<int>(k) == shadow_light);
  return text;
}

}  // namespace

MainPass::MainPass(const Gl& gl, const std::filesystem::path& shaders) : gl_(gl), shaders_(shaders) {
  static_assert(surface_defines.size() == surfaces);
  programs_for(lights_define({}, -1));
}

const MainPass::Programs& MainPass::programs_for(const std::string& lights) {
  if (lights == compiled_lights_) return programs_;
  Programs programs;
  for (std::size_t k = 0; k < surfaces; ++k)
    programs[k] = std::make_unique<ShaderProgram>(gl_, shaders_, "main",
                                                  std::vector<std::string>{surface_defines[k], lights});
  programs_ = std::move(programs);
  compiled_lights_ = lights;
  return programs_;
}

void MainPass::draw(const DrawList& list, const DrawCamera& camera, const std::vector<QueuedItem>& items,
                    const MeshCache& meshes, const Shadow& shadow) {
  gl_.Enable(GL_DEPTH_TEST);
  gl_.DepthMask(GL_TRUE);
  gl_.Enable(GL_CULL_FACE);
  gl_.CullFace(GL_BACK);
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.BindTexture(GL_TEXTURE_2D, shadow.texture);
  const Programs& programs = programs_for(lights_define(list.lights, shadow.light));
  std::array<bool, surfaces> is_set{};
  const Frustum frustum(view_projection_of(camera));
  for (const QueuedItem& queued : items) {
    if (!frustum.may_see(queued.bounds)) continue;
    const auto kind = static_cast<std::size_t>(queued.item->surface);
    const ShaderProgram& program = *programs.at(kind);
    program.use();
    if (!is_set[kind]) set_frame(program, list, camera, shadow);
    is_set[kind] = true;
    set_item(program, *queued.item);
    meshes.draw(queued.mesh);
  }
  gl_.Disable(GL_CULL_FACE);
}

}  // namespace prosector
