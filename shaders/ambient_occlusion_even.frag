// The mean of 4 × 4 places, so that each of their sixteen ways to look counts as much. Places of another surface
// do not count: they would leave rims.

#include "ambient_occlusion.glsl"

uniform sampler2D openness;

out vec4 color;

void main() {
  ivec2 here = ivec2(gl_FragCoord.xy), most = textureSize(openness, 0) - 1;
  vec2 size = vec2(most + 1), low = (vec2(here) - 1.0) / size, high = (vec2(here) + 1.0) / size;
  // Four reads of four places each: most of a picture is open.
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
  color = vec4(sum / weights);  // its own place is in its plane
}
