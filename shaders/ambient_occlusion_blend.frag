// Applies the ambient occlusion to the frame: interpolates between the four samples around a pixel, using
// only those in the pixel's plane. This avoids halos at nearer and farther surfaces.

#include "ambient_occlusion.glsl"

uniform sampler2D openness;

out vec4 color;

const float unknown = 0.02;  // weight of full openness, for a pixel without a usable sample

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy), most = textureSize(openness, 0) - 1;
  // Position of the pixel in the grid of samples.
  vec2 at = vec2(pixel - COARSER / 2) / float(COARSER);
  if (texture(openness, (at + 0.5) / vec2(most + 1)).r > 0.995) discard;
  ivec2 first = ivec2(floor(at));
  vec2 past = at - vec2(first);
  Plane plane = plane_at(pixel);
  float sum = unknown, weights = unknown;
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 2; ++x) {
      ivec2 place = clamp(first + ivec2(x, y), ivec2(0), most);
      float share = (x == 0 ? 1.0 - past.x : past.x) * (y == 0 ? 1.0 - past.y : past.y);
      if (share == 0.0) continue;
      float weight = share * in_plane(plane, pixel_of(place));
      sum += weight * texelFetch(openness, place, 0).r;
      weights += weight;
    }
  }
  color = vec4(sum / weights);
}
