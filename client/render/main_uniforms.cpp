#include "client/render/main_uniforms.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "client/render/refraction.h"

namespace prosector {
namespace {

constexpr double least_pixels = 1.5;  // minimum width of slender items, so that they are never dotted

// The order of Surface.
constexpr std::array<const char*, 11> surface_defines = {
    "SURFACE_PLAIN", "SURFACE_TISSUE",   "SURFACE_BONE",  "SURFACE_METAL", "SURFACE_SKIN",   "SURFACE_CLOTH",
    "SURFACE_GLASS", "SURFACE_EMISSIVE", "SURFACE_FLOOR", "SURFACE_WALL",  "SURFACE_CEILING"};

Eigen::Vector4f vec4(const Vec3& v, double w) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z()),
          static_cast<float>(w)};
}

/// Returns whether a light's cone may reach the sphere. Point and directional lights reach everywhere.
bool may_light(const LightInfo& light, const Sphere& sphere) {
  if (light.kind != LightKind::spot) return true;
  const Vec3 offset = sphere.center - light.position;
  const double along = offset.dot(light.direction.normalized());
  const double across = std::sqrt(std::max(offset.squaredNorm() - along * along, 0.0));
  return across * std::cos(light.cone) - along * std::sin(light.cone) <= sphere.radius;
}

/// Sets the lights as the shader's arrays; w holds the cosine of the cone and that of its full-strength core.
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

static_assert(surface_defines.size() == static_cast<std::size_t>(last_surface) + 1);

}  // namespace

LightSet lights_of(const QueuedItem& queued, const std::vector<LightInfo>& lights) {
  const Surface surface = queued.item->appearance.surface;
  LightSet out;
  for (std::size_t k = 0; k < std::min(lights.size(), max_lights); ++k)
    out[k] = !is_room(surface) || may_light(lights[k], queued.bounds);
  return out;
}

std::vector<std::string> light_defines(const std::vector<LightInfo>& lights, const LightSet& set,
                                       int shadow_light) {
  std::string each = "EACH_LIGHT(X)";
  for (std::size_t k = 0; k < std::min(lights.size(), max_lights); ++k)
    if (set[k]) each += fmt::format(" X({}, {})", k, static_cast<int>(lights[k].kind));
  const bool shadowed = shadow_light >= 0 && set[static_cast<std::size_t>(shadow_light)];
  return {each, fmt::format("SHADOW_LIGHT {}", shadowed ? shadow_light : -1)};
}

bool is_brushed(const DrawItem& item) {
  return item.appearance.surface == Surface::metal && !item.painted && !item.mesh->slender.isZero(0);
}

std::vector<std::string> item_defines(Surface surface, bool is_wet, std::vector<std::string> defines) {
  defines.push_back(surface_defines.at(static_cast<std::size_t>(surface)));
  if (is_wet) defines.push_back("WET");
  return defines;
}

void set_frame(const ShaderProgram& program, const DrawList& list, const DrawCamera& camera,
               const Shadow& shadow, const Environment& environment) {
  program.set("clip_from_room", view_projection_of(camera));
  program.set("eye", camera.pose.p);
  program.set("least_half_width", 0.5 * least_pixels * (camera.top - camera.bottom) / camera.height);
  program.set("ambient", list.ambient);
  program.set("shadow_map", 0);
  program.set("environment_map", 1);
  program.set("irradiance", environment.irradiance);
  program.set("shadow_clip_from_room", shadow.clip_from_room);
  program.set("shadow_size", shadow.size);
  program.set("shadow_offset", 2 * shadow.texel);
  set_lights(program, list.lights);
}

Affine normal_map(const DrawItem& item) {
  const Mat3 linear = item.shape.A * item.pose.q.toRotationMatrix();
  Affine out;
  out.A = item.shape.A.isIdentity(0) || std::abs(linear.determinant()) < 1e-12
              ? Mat3(item.pose.q.toRotationMatrix())
              : Mat3(linear.inverse().transpose());
  return out;
}

void set_clip_plane(const ShaderProgram& program, const Eigen::Vector4d& kept) {
  program.set("kept", std::vector<Eigen::Vector4f>{kept.cast<float>()});
}

void set_placement(const ShaderProgram& program, const DrawItem& item) {
  program.set("room_from_mesh", matrix_of(item));
  program.set("room_from_normal", matrix_of(normal_map(item)));
}

void set_item(const ShaderProgram& program, const DrawItem& item) {
  set_placement(program, item);
  program.set("base_color", item.appearance.color);
  program.set("base_roughness", item.appearance.roughness);
  program.set("wetness", item.appearance.wetness);
  program.set("brightness", item.brightness);
  program.set("opacity", std::clamp(item.opacity, 0.0, 1.0));
  if (is_brushed(item)) program.set("long_axis", item.mesh->slender);
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

}  // namespace prosector
