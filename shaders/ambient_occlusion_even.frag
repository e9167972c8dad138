// Averages 4 × 4 samples, so that each of their sixteen directions has the same weight. Samples of other
// surfaces are excluded, because they would cause halos.

#include "ambient_occlusion.glsl"

uniform sampler2D openness;

out vec4 color;

void main() {
  ivec2 here = ivec2(gl_FragCoord.xy), most = textureSize(openness, 0) - 1;
  vec2 size = vec2(most + 1), low = (vec2(here) - 1.0) / size, high = (vec2(here) + 1.0) / size;
  // Four reads of four samples each, as an early exit: most of a frame is open.
  float least = min(min(texture(openness, low).r, texture(openness, vec2(high.x, low.y)).r),
                    min(texture(openness, vec2(low.x, high.y)).r, texture(openness, high).r));
  if (least > 0.998) discard;
  Plane plane = plane_at(pixel_of(here));
  float sum = 0.0, weights = 0.0;
  for (int y = -2; y < 2; ++y) {
    for (int x = -2; x < 2; ++x) {
      ivec2 place = clamp(here + ivec2(x, y), ivec2(0), most);
      float weight = in_plane(plane, pixel_of(place));
      sum += weight * texelFetch(openness, place, 0).r;
      weights += weight;
    }
  }
  color = vec4(sum / weights);  // weights > 0, since the pixel's own sample is in its plane
}
