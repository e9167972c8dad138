layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 rest;
layout(location = 3) in float hollow;

uniform mat4 room_from_mesh;
uniform mat4 room_from_normal;
uniform mat4 clip_from_room;

out vec3 room_place;
out vec3 room_normal;
out vec3 rest_place;
out float hollowness;
#if SHADOW_LIGHT >= 0
uniform mat4 shadow_clip_from_room;
uniform float shadow_offset;
out vec4 shadow_place;
#endif

void main() {
  vec4 place = room_from_mesh * vec4(position, 1.0);
  room_place = place.xyz;
  room_normal = mat3(room_from_normal) * normal;
  rest_place = rest;
  hollowness = hollow;
#if SHADOW_LIGHT >= 0
  // Moved off the surface by about a texel, so that it does not shade itself. w is the distance to the light.
  vec4 unmoved = shadow_clip_from_room * place;
  shadow_place = unmoved + shadow_clip_from_room * vec4(room_normal * (shadow_offset * unmoved.w), 0.0);
#endif
  gl_Position = clip_from_room * place;
}
