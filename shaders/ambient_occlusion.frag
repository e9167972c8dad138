// Ambient occlusion: computes the openness of a point's surroundings: 1 on a plane, less in a crease.

#include "ambient_occlusion.glsl"

out vec4 color;

const float farthest = 2.4;       // m: no darkening beyond …
const float fades = 1.6;          // m: … and a fade from here on
const float most_pixels = 56.0;   // limit of the sphere's radius
const float strength = 1.15;

// Returns by how much the filled part of two lines through the sphere exceeds one half. The lines are
// parallel to the eye's ray, `offset` pixels to both sides of its centre, `half_length` radii each way.
// `radii`: radii per 1/m of nearness.
float filled(ivec2 here, vec2 offset, float half_length, float nearness, float radii) {
  ivec2 aside = ivec2(floor(offset + 0.5));
  vec2 rises = radii * (vec2(nearness_at(here + aside), nearness_at(here - aside)) - nearness);
  vec2 full = clamp(0.5 + (0.5 / half_length) * rises, 0.0, 1.0);
  // A surface far in front of the sphere gives no information: the value mirrored from the other side is
  // used.
  full = mix(1.0 - full.yx, full, clamp(2.2 - rises, 0.0, 1.0));
  return full.x + full.y - 1.0;
}

// Returns 0 … 3 for a position among 2 × 2, very different from those of its neighbours.
int spread(ivec2 cell) { return 2 * (cell.x ^ cell.y) + cell.y; }

void main() {
  ivec2 here = pixel_of(ivec2(gl_FragCoord.xy));
  float nearness = nearness_at(here);
  float distance = 1.0 / nearness;
  if (distance > farthest) discard;
  float pixels = lens[0].z * nearness;  // per metre
  // The sphere is limited to the viewport's border.
  vec2 low = vec2(here) - viewport[0].xy, high = viewport[0].zw - 1.0 - low;
  float border = min(min(low.x, low.y), min(high.x, high.y));
  float reach = max(min(min(lens[0].w * pixels, most_pixels), border), 0.4);
  float radii = distance * distance * pixels / reach;

  // Sixteen neighbouring samples together use 16 × 8 directions and 16 × 4 distances.
  ivec2 cell = ivec2(gl_FragCoord.xy) & 3;
  int which = 4 * spread(cell & 1) + spread(cell >> 1);
  float turn = 0.04908739 * (float(which) + 0.5);
  vec2 d = reach * (0.85 + 0.02 * float((5 * which) & 15)) * vec2(cos(turn), sin(turn));
  vec2 e = 0.70710678 * vec2(d.x - d.y, d.x + d.y);
  float sum = 0.31 * filled(here, 0.46 * e, 0.888, nearness, radii);
  sum += 0.24 * filled(here, 0.66 * vec2(-e.y, e.x), 0.751, nearness, radii);
  sum += 0.35 * filled(here, 0.25 * d, 0.968, nearness, radii);
  sum += 0.10 * filled(here, 0.84 * vec2(-d.y, d.x), 0.543, nearness, radii);
  float fade = clamp((farthest - distance) / (farthest - fades), 0.0, 1.0);
  color = vec4(1.0 - strength * fade * max(sum - 0.02, 0.0));
}
