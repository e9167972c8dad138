#pragma once
// What the surfaces' shaders are compiled with, and what they are told. Private to client/render.

#include <bitset>
#include <string>
#include <vector>

#include "client/render/draw_queue.h"
#include "client/render/environment.h"
#include "client/render/shader_program.h"
#include "client/render/shadow_pass.h"

namespace prosector {

using LightSet = std::bitset<max_lights>;

inline constexpr int first_glass_unit = 2;  // of textures, after shadow and environment

/// Tells whether it is the client's own room that looks so.
inline bool is_room(Surface surface) {
  return surface > last_body_surface;
}

/// Returns a set whose bit k says that light k is to be reckoned with. Only the room is spared lights that
/// don't reach it: what moves in and out of a cone would need shaders compiled on the way.
LightSet lights_of(const QueuedItem& queued, const std::vector<LightInfo>& lights);

/// Returns what shaders/lighting.glsl is compiled with: the lights' kinds, and which has the shadow map.
std::vector<std::string> light_defines(const std::vector<LightInfo>& lights, const LightSet& set,
                                       int shadow_light);

/// Tells whether the item is of metal that was ground along its long axis, as instruments are.
bool is_brushed(const DrawItem& item);

std::vector<std::string> item_defines(Surface surface, bool is_wet, std::vector<std::string> defines);

void set_frame(const ShaderProgram& program, const DrawList& list, const DrawCamera& camera,
               const Shadow& shadow, const Environment& environment);

/// Sets the side of a plane that is drawn: where its product with a place is above zero.
void set_kept(const ShaderProgram& program, const Eigen::Vector4d& kept);

/// Sets where the item is, as room_from_mesh and room_from_normal.
void set_placement(const ShaderProgram& program, const DrawItem& item);

/// Returns the map of normals, which go with the inverse's transpose; a shape without volume has none.
Affine normal_map(const DrawItem& item);

void set_item(const ShaderProgram& program, const DrawItem& item);

void set_refraction(const ShaderProgram& program, const DrawCamera& camera);

}  // namespace prosector
