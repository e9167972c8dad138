// Light scattered by dust in a spot light's beam: single scattering, summed over a few points on the part of
// the eye's ray inside the cone and in front of the first surface. Shadowed points contribute nothing.

uniform sampler2D scene_depth;
uniform sampler2D shadow_map;
uniform float shadow_size;
uniform mat4 shadow_clip_from_room;
uniform mat4 room_from_clip;
uniform vec4 viewport[1];  // x, y, width, height, in pixels of this layer, which is coarser than scene_depth by COARSER
uniform vec3 eye;
uniform vec3 lamp;
uniform vec3 axis;
uniform float cone;
uniform float core;  // cosine of the angle within which the light has full strength
uniform float reach;
uniform vec3 light;

in vec3 room_place;
out vec4 color;

const int steps = 6;
const float scattered = 0.006;  // fraction of light per metre
const float least_distance = 0.3;  // m from the lamp: closer, the beam does not get brighter

void main() {
  vec3 ray = normalize(room_place - eye);
  vec2 at = (gl_FragCoord.xy - viewport[0].xy) / viewport[0].zw;
  float depth = texelFetch(scene_depth, min(COARSER * ivec2(gl_FragCoord.xy) + COARSER / 2, textureSize(scene_depth, 0) - 1), 0).r;
  vec4 surface = room_from_clip * vec4(2.0 * vec3(at, depth) - 1.0, 1.0);
  float last = min(dot(surface.xyz / surface.w - eye, ray), dot(room_place - eye, ray));

  // Intersection of the ray and the cone: |x·axis|² = cos² |x|², x = offset + t ray.
  vec3 offset = eye - lamp;
  float outer = cos(cone), c2 = outer * outer;
  float u = dot(ray, axis), w = dot(offset, axis);
  float a = u * u - c2, b = u * w - c2 * dot(ray, offset), c = w * w - c2 * dot(offset, offset);
  bool inside = w > 0.0 && c > 0.0;
  float first = 0.0;
  if (!inside) {
    float root = sqrt(max(b * b - a * c, 0.0));
    float t0 = (-b - root) / a, t1 = (-b + root) / a;
    float near = min(t0, t1), far = max(t0, t1);
    first = near > 0.0 && w + near * u > 0.0 ? near : far;
  }
  float span = last - first;
  if (!(span > 0.0)) discard;

  // Each pixel of 4 × 4 starts at a different offset, so that few steps cause no banding.
  ivec2 cell = ivec2(gl_FragCoord.xy) & 3;
  float start = (float((cell.x * 4 + cell.y * 10 + (cell.x & 1) * 7) & 15) + 0.5) / 16.0;
  float sum = 0.0;
  for (int k = 0; k < steps; ++k) {
    vec3 place = eye + (first + span * (float(k) + start) / float(steps)) * ray;
    vec3 from = place - lamp;
    float squared = max(dot(from, from), least_distance * least_distance);
    float strength = smoothstep(outer, core, dot(from, axis) * inversesqrt(squared)) / squared;
    vec4 clip = shadow_clip_from_room * vec4(place, 1.0);
    vec3 texel = clip.xyz / clip.w * 0.5 + 0.5;
    float nearest = texelFetch(shadow_map, ivec2(clamp(texel.xy * shadow_size, vec2(0.0), vec2(shadow_size - 1.0))), 0).r;
    sum += min(texel.z, 1.0) <= nearest ? strength : 0.0;
  }
  color = vec4(light * (scattered * span / float(steps) * sum), 0.0);
}
