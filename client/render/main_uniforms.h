#pragma once
// Macros and uniforms of the surface shaders. Private to client/render.

#include <bitset>
#include <string>
#include <vector>

#include "client/render/draw_queue.h"
#include "client/render/environment.h"
#include "client/render/shader_program.h"
#include "client/render/shadow_pass.h"

namespace prosector {

using LightSet = std::bitset<max_lights>;

inline constexpr int first_glass_unit = 2;  // texture unit, after shadow and environment

/// Returns whether the surface belongs to the client's own room.
inline bool is_room(Surface surface) {
  return surface > last_body_surface;
}

/// Returns a set whose bit k means that light k is included. Lights out of reach are omitted only for the
/// room. Moving bodies enter and leave light cones, which would require compiling shaders while running.
LightSet lights_of(const QueuedItem& queued, const std::vector<LightInfo>& lights);

/// Returns the macros for shaders/lighting.glsl: the lights' kinds, and the light with the shadow map.
std::vector<std::string> light_defines(const std::vector<LightInfo>& lights, const LightSet& set,
                                       int shadow_light);

/// Returns whether the item is of metal with grinding marks along its long axis, such as an instrument.
bool is_brushed(const DrawItem& item);

std::vector<std::string> item_defines(Surface surface, bool is_wet, std::vector<std::string> defines);

void set_frame(const ShaderProgram& program, const DrawList& list, const DrawCamera& camera,
               const Shadow& shadow, const Environment& environment);

/// Sets the clipping plane: points with a positive product with it are drawn.
void set_clip_plane(const ShaderProgram& program, const Eigen::Vector4d& kept);

/// Sets the item's transformations room_from_mesh and room_from_normal.
void set_placement(const ShaderProgram& program, const DrawItem& item);

/// Returns the map for normals: the inverse transpose of the item's map. For a shape without volume, the
/// rotation of the pose only.
Affine normal_map(const DrawItem& item);

void set_item(const ShaderProgram& program, const DrawItem& item);

void set_refraction(const ShaderProgram& program, const DrawCamera& camera);

}  // namespace prosector
