#include "client/render/main_pass.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <set>
#include <tuple>

#include "client/render/effects.h"

namespace prosector {
namespace {

constexpr int first_glass_unit = 2;  // of textures, after shadow and environment

using LightSet = std::bitset<max_lights>;

// The order of Surface.
constexpr std::array<const char*, 10> surface_defines = {
    "SURFACE_PLAIN", "SURFACE_TISSUE", "SURFACE_BONE",     "SURFACE_METAL", "SURFACE_SKIN",
    "SURFACE_CLOTH", "SURFACE_GLASS",  "SURFACE_EMISSIVE", "SURFACE_FLOOR", "SURFACE_WALL"};

Eigen::Vector4f vec4(const Vec3& v, double w) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z()),
          static_cast<float>(w)};
}

/// A light's cone may reach the sphere. Point and directional lights reach everywhere.
bool may_light(const LightInfo& light, const Sphere& sphere) {
  if (light.kind != LightKind::spot) return true;
  const Vec3 offset = sphere.center - light.position;
  const double along = offset.dot(light.direction.normalized());
  const double across = std::sqrt(std::max(offset.squaredNorm() - along * along, 0.0));
  return across * std::cos(light.cone) - along * std::sin(light.cone) <= sphere.radius;
}

/// Bit k: light k is to be reckoned with. Only the room is spared lights that don't reach it: what moves in
/// and out of a cone would need shaders compiled on the way.
LightSet lights_of(const QueuedItem& queued, const std::vector<LightInfo>& lights) {
  const Surface surface = queued.item->appearance.surface;
  const bool is_room = surface == Surface::floor || surface == Surface::wall;
  LightSet out;
  for (std::size_t k = 0; k < std::min(lights.size(), max_lights); ++k)
    out[k] = !is_room || may_light(lights[k], queued.bounds);
  return out;
}

/// What shaders/lighting.glsl is compiled with: the lights' kinds, and which has the shadow map.
std::vector<std::string> light_defines(const std::vector<LightInfo>& lights, const LightSet& set,
                                       int shadow_light) {
  std::string each = "EACH_LIGHT(X)";
  for (std::size_t k = 0; k < std::min(lights.size(), max_lights); ++k)
    if (set[k]) each += fmt::format(" X({}, {})", k, static_cast<int>(lights[k].kind));
  const bool shadowed = shadow_light >= 0 && set[static_cast<std::size_t>(shadow_light)];
  return {each, fmt::format("SHADOW_LIGHT {}", shadowed ? shadow_light : -1)};
}

std::vector<std::string> item_defines(Surface surface, bool is_wet, std::vector<std::string> defines) {
  defines.push_back(surface_defines.at(static_cast<std::size_t>(surface)));
  if (is_wet) defines.push_back("WET");
  return defines;
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
  program.set("environment_map", 1);
  program.set("shadow_clip_from_room", shadow.clip_from_room);
  program.set("shadow_size", shadow.size);
  program.set("shadow_offset", 2 * shadow.texel);
  set_lights(program, list.lights);
}

/// Normals go with the inverse's transpose; a shape without volume has none.
Affine normal_map(const DrawItem& item) {
  const Mat3 linear = item.shape.A * item.pose.q.toRotationMatrix();
  Affine out;
  out.A = item.shape.A.isIdentity(0) || std::abs(linear.determinant()) < 1e-12
              ? Mat3(item.pose.q.toRotationMatrix())
              : Mat3(linear.inverse().transpose());
  return out;
}

void set_item(const ShaderProgram& program, const DrawItem& item) {
  set_placement(program, item);
  program.set("base_color", item.appearance.color);
  program.set("base_roughness", item.appearance.roughness);
  program.set("wetness", item.appearance.wetness);
  program.set("brightness", item.brightness);
  if (item.appearance.surface != Surface::glass) return;
  program.set("refractive_index", refractive_indices(item.appearance));
  program.set("transmittance", item.appearance.transmittance);
}

void set_refraction(const ShaderProgram& program, const DrawCamera& camera) {
  program.set("room_from_clip", Eigen::Matrix4d(view_projection_of(camera).inverse()));
  program.set("viewport",
              std::vector<Eigen::Vector4f>{
                  Eigen::Vector4i(camera.x, camera.y, camera.width, camera.height).cast<float>()});
  int unit = first_glass_unit;
  for (const char* name : {"picture", "scene_depth", "front_depth", "back_depth", "back_normals"})
    program.set(name, unit++);
}

/// An eye, and the near plane ahead of it, may be inside of the body, which then shows its inner face rather
/// than the room behind it.
bool may_be_around(const Vec3& eye, const QueuedItem& queued) {
  const Surface surface = queued.item->appearance.surface;
  return (surface == Surface::tissue || surface == Surface::bone) &&
         (eye - queued.bounds.center).norm() <= queued.bounds.radius;
}

/// Too small on the picture to be met by a pixel's middle, but by luck.
bool is_below_a_pixel(const DrawCamera& camera, const Sphere& sphere) {
  constexpr double least = 0.5;  // pixels across
  const double pixels_per_tangent = camera.height / (camera.top - camera.bottom);
  const double distance = (sphere.center - camera.pose.p).norm() - sphere.radius;
  return distance > 0 && 2 * sphere.radius / distance * pixels_per_tangent < least;
}

bool is_clear(const DrawItem& item) {
  return item.opacity < 1;
}

}  // namespace

void set_placement(const ShaderProgram& program, const DrawItem& item) {
  program.set("room_from_mesh", matrix_of(item));
  program.set("room_from_normal", matrix_of(normal_map(item)));
}

bool is_glass(const DrawItem& item) {
  return item.appearance.surface == Surface::glass && !item.painted && !item.shaft && item.opacity >= 1;
}

struct MainPass::Frame {
  const DrawList& list;
  const DrawCamera& camera;
  const MeshCache& meshes;
  const Shadow& shadow;
  bool refracts = false;  // glass is drawn over a picture of what is behind it
  std::map<std::tuple<Surface, bool, bool, bool, unsigned long>, const ShaderProgram*> found = {};
  std::set<const ShaderProgram*> set_up = {};
};

MainPass::MainPass(const Gl& gl, const std::filesystem::path& shaders, std::vector<std::string> defines)
    : gl_(gl),
      shaders_(shaders),
      defines_(std::move(defines)),
      refracts_(std::ranges::count(defines_, effect_rows[index_of(Effect::refraction)].define) > 0) {}

void MainPass::compile_all() {
  static_assert(surface_defines.size() == static_cast<std::size_t>(Surface::wall) + 1);
  for (std::size_t k = 0; k < surface_defines.size(); ++k)
    program_for(item_defines(static_cast<Surface>(k), true, light_defines(std::vector<LightInfo>(1), 1, 0)));
  if (!refracts_) return;
  Defines glass = item_defines(Surface::glass, false, light_defines(std::vector<LightInfo>(1), 1, 0));
  glass.push_back("REFRACTS");
  program_for(glass);
}

const ShaderProgram& MainPass::program_for(const Defines& defines) {
  auto& program = programs_[defines];
  if (!program) {
    Defines all = defines_;
    all.insert(all.end(), defines.begin(), defines.end());
    program = std::make_unique<ShaderProgram>(gl_, shaders_, "main", all);
  }
  return *program;
}

/// The item's program, in use and with all that it needs.
const ShaderProgram& MainPass::ready(const QueuedItem& queued, Frame& frame) {
  const DrawItem& item = *queued.item;
  const bool is_wet = item.appearance.wetness > 0;
  const LightSet lights = item.shaft || item.painted ? LightSet() : lights_of(queued, frame.list.lights);
  const ShaderProgram*& program =
      frame.found[{item.appearance.surface, is_wet, item.shaft, item.painted, lights.to_ulong()}];
  if (!program) {
    Defines defines = item_defines(item.appearance.surface, is_wet,
                                   light_defines(frame.list.lights, lights, frame.shadow.light));
    if (item.shaft) defines.push_back("SHAFT");
    if (item.painted) defines.push_back("PAINTED");
    if (frame.refracts) defines.push_back("REFRACTS");
    program = &program_for(defines);
  }
  program->use();
  if (frame.set_up.insert(program).second) {
    set_frame(*program, frame.list, frame.camera, frame.shadow);
    if (frame.refracts) set_refraction(*program, frame.camera);
  }
  set_item(*program, item);
  return *program;
}

/// Calls draw() for its front, and first for its inside where that is seen.
template <class Draw>
void MainPass::draw_sides(const QueuedItem& queued, Frame& frame, const Draw& draw) {
  const ShaderProgram& program = ready(queued, frame);
  const DrawItem& item = *queued.item;
  const bool mirrored = item.shape.A.determinant() < 0;
  if (item.seen_from_inside || may_be_around(frame.camera.pose.p, queued)) {
    const Eigen::Matrix4d normals = matrix_of(normal_map(item));
    program.set("room_from_normal", Eigen::Matrix4d(-normals));
    gl_.CullFace(mirrored ? GL_BACK : GL_FRONT);
    draw();
    program.set("room_from_normal", normals);
  }
  gl_.CullFace(mirrored ? GL_FRONT : GL_BACK);
  draw();
  gl_.CullFace(GL_BACK);
}

void MainPass::draw_solid(const QueuedItem& queued, Frame& frame) {
  draw_sides(queued, frame, [&] { frame.meshes.draw(queued.mesh); });
}

/// First its depth alone, so that of a body only the front is seen, not its inside and its back.
void MainPass::draw_clear(const QueuedItem& queued, Frame& frame) {
  draw_sides(queued, frame, [&] {
    gl_.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    frame.meshes.draw(queued.mesh);
    gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl_.DepthFunc(GL_LEQUAL);
    gl_.Enable(GL_BLEND);
    gl_.BlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
    gl_.BlendColor(0, 0, 0, static_cast<float>(std::clamp(queued.item->opacity, 0.0, 1.0)));
    frame.meshes.draw(queued.mesh);
    gl_.Disable(GL_BLEND);
    gl_.DepthFunc(GL_LESS);
  });
}

/// Glass without refraction: what is straight behind, less what its face mirrors and its body swallows.
void MainPass::draw_pane(const QueuedItem& queued, Frame& frame) {
  ready(queued, frame);
  gl_.CullFace(queued.item->shape.A.determinant() < 0 ? GL_FRONT : GL_BACK);
  gl_.DepthMask(GL_FALSE);
  gl_.Enable(GL_BLEND);
  gl_.BlendFuncSeparate(GL_ONE, GL_SRC_ALPHA, GL_ZERO, GL_ONE);
  frame.meshes.draw(queued.mesh);
  gl_.Disable(GL_BLEND);
  gl_.DepthMask(GL_TRUE);
  gl_.CullFace(GL_BACK);
}

void MainPass::draw_shaft(const QueuedItem& queued, Frame& frame) {
  ready(queued, frame);
  gl_.DepthMask(GL_FALSE);
  gl_.Enable(GL_BLEND);
  gl_.BlendFunc(GL_ONE, GL_ONE);
  frame.meshes.draw(queued.mesh);
  gl_.Disable(GL_BLEND);
  gl_.DepthMask(GL_TRUE);
}

void MainPass::draw(const DrawList& list, const DrawCamera& camera, const std::vector<QueuedItem>& items,
                    const MeshCache& meshes, const Shadow& shadow, GLuint environment) {
  gl_.Enable(GL_DEPTH_TEST);
  gl_.DepthMask(GL_TRUE);
  gl_.Enable(GL_CULL_FACE);
  gl_.CullFace(GL_BACK);
  gl_.ActiveTexture(GL_TEXTURE1);
  gl_.BindTexture(GL_TEXTURE_CUBE_MAP, environment);
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.BindTexture(GL_TEXTURE_2D, shadow.texture);
  const Frustum frustum(view_projection_of(camera));
  Frame frame{list, camera, meshes, shadow};
  std::vector<const QueuedItem*> clear, shafts;
  for (const QueuedItem& queued : items) {
    if (!frustum.may_see(queued.bounds) || is_below_a_pixel(camera, queued.bounds)) continue;
    if (queued.item->shaft)
      shafts.push_back(&queued);
    else if (is_glass(*queued.item) && refracts_ && !camera.inset)
      continue;
    else if (is_clear(*queued.item) || is_glass(*queued.item))
      clear.push_back(&queued);
    else
      draw_solid(queued, frame);
  }
  for (auto queued = clear.rbegin(); queued != clear.rend(); ++queued)
    is_glass(*(*queued)->item) ? draw_pane(**queued, frame) : draw_clear(**queued, frame);
  for (const QueuedItem* queued : shafts) draw_shaft(*queued, frame);
  gl_.Disable(GL_CULL_FACE);
}

void MainPass::draw_glass(const DrawList& list, const DrawCamera& camera,
                          const std::vector<const QueuedItem*>& glass, const MeshCache& meshes,
                          const Shadow& shadow, GLuint environment, const Refraction& seen) {
  GLenum unit = GL_TEXTURE0 + first_glass_unit;
  for (const GLuint texture :
       {seen.picture, seen.scene_depth, seen.front_depth, seen.back_depth, seen.back_normals}) {
    gl_.ActiveTexture(unit++);
    gl_.BindTexture(GL_TEXTURE_2D, texture);
  }
  gl_.ActiveTexture(GL_TEXTURE1);
  gl_.BindTexture(GL_TEXTURE_CUBE_MAP, environment);
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.BindTexture(GL_TEXTURE_2D, shadow.texture);
  gl_.Enable(GL_DEPTH_TEST);
  gl_.Enable(GL_CULL_FACE);
  gl_.DepthMask(GL_FALSE);
  Frame frame{list, camera, meshes, shadow, true};
  for (const QueuedItem* queued : glass) {
    ready(*queued, frame);
    gl_.CullFace(queued->item->shape.A.determinant() < 0 ? GL_FRONT : GL_BACK);
    frame.meshes.draw(queued->mesh);
  }
  gl_.CullFace(GL_BACK);
  gl_.DepthMask(GL_TRUE);
  gl_.Disable(GL_CULL_FACE);
}

}  // namespace prosector
