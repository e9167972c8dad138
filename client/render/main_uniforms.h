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

/// Returns whether the surface belongs to the room that the client draws around the scene: floor, walls or
/// ceiling.
inline bool is_room(Surface surface) {
  return surface > last_body_surface;
}

/// Returns the lights by which the item is shaded: bit k of the set stands for light k. Only for the room,
/// lights out of reach are omitted. Moving bodies enter and leave light cones, and each new set would require
/// compiling a shader while running.
LightSet lights_of(const QueuedItem& queued, const std::vector<LightInfo>& lights);

/// Returns the macros with which shaders/lighting.glsl is compiled. They state the kind of each light of
/// `set`, and the index of the light with the shadow map, −1 for none.
std::vector<std::string> light_defines(const std::vector<LightInfo>& lights, const LightSet& set,
                                       int shadow_light);

/// Returns whether the item is of metal with grinding marks along its long axis, such as an instrument: a
/// metal surface on a long thin mesh, without painted colours.
bool is_brushed(const DrawItem& item);

std::vector<std::string> item_defines(Surface surface, bool is_wet, std::vector<std::string> defines);

void set_frame(const ShaderProgram& program, const DrawList& list, const DrawCamera& camera,
               const Shadow& shadow, const Environment& environment);

/// Sets the clipping plane of the shader program in use. Points of the room whose homogeneous coordinates
/// have a positive product with `kept` are drawn; the others are clipped.
void set_clip_plane(const ShaderProgram& program, const Eigen::Vector4d& kept);

/// Sets the uniforms room_from_mesh and room_from_normal of the shader program in use: the item's
/// transformations of points and normals from its mesh to the room.
void set_placement(const ShaderProgram& program, const DrawItem& item);

/// Returns the transformation of the item's normals from its mesh to the room: the inverse transpose of that
/// of its points. For a shape without volume, returns the rotation of its pose only.
Affine normal_map(const DrawItem& item);

void set_item(const ShaderProgram& program, const DrawItem& item);

void set_refraction(const ShaderProgram& program, const DrawCamera& camera);

}  // namespace prosector
