layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 rest;
layout(location = 3) in float hollow;

uniform mat4 room_from_mesh;
uniform mat4 room_from_normal;
uniform mat4 clip_from_room;
uniform vec4 kept;  // clipping plane: its product with a point is positive on the remaining side of the section

#ifdef BRUSHED
uniform vec3 long_axis;          // of a slender item, in the mesh's frame
uniform vec3 eye;
uniform float least_half_width;  // m, at a distance of 1 m

// Slender items are widened to a pixel or two at any distance; otherwise they would look dotted.
vec3 widened(vec3 at) {
  float least = least_half_width * distance(eye, (room_from_mesh * vec4(at, 1.0)).xyz);
  return mix(sign(at) * max(abs(at), least), at, long_axis);
}
#endif

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
#ifdef BRUSHED
  vec4 place = room_from_mesh * vec4(widened(position), 1.0);
#else
  vec4 place = room_from_mesh * vec4(position, 1.0);
#endif
  room_place = place.xyz;
  room_normal = mat3(room_from_normal) * normal;
  rest_place = rest;
  hollowness = hollow;
#if SHADOW_LIGHT >= 0
  // Offset from the surface by about a texel, to avoid self-shadowing. w is the distance to the light.
  vec4 unmoved = shadow_clip_from_room * place;
  shadow_place = unmoved + shadow_clip_from_room * vec4(room_normal * (shadow_offset * unmoved.w), 0.0);
#endif
  gl_ClipDistance[0] = dot(kept, place);
  gl_Position = clip_from_room * place;
}
