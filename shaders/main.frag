#include "color.glsl"
#include "noise.glsl"
#include "surfaces.glsl"
#include "lighting.glsl"

in vec3 room_place;
in vec3 room_normal;
in vec3 rest_place;

uniform mat4 room_from_mesh;
uniform vec3 eye;
uniform float brightness;

out vec4 color;

void main() {
  vec3 smooth_normal = normalize(room_normal);
#ifdef SHAFT
  // Dust in the light: the eye looks through most of it in the middle, through little at the rim.
  float through = abs(dot(smooth_normal, normalize(eye - room_place)));
  float left = mix(1.0, 0.5, rest_place.x) * (1.0 - smoothstep(0.85, 1.0, rest_place.x));
  color = with_brightness(brightness * base_color * through * through * left);
#else
  Material material = material_at(rest_place);
  vec3 normal = smooth_normal;
  vec3 film_normal = smooth_normal;
#ifdef RELIEF
  vec3 slope = mat3(room_from_mesh) * material.slope;
  normal = normalize(smooth_normal - (slope - dot(slope, smooth_normal) * smooth_normal));
  film_normal = normalize(normal + smooth_normal);
#endif
  vec3 radiance = shade(material, room_place, normal, film_normal, normalize(eye - room_place));
  color = with_brightness(srgb(tone_map(brightness * radiance)));
#endif
}
