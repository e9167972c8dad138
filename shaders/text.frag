// A stroke with round ends; what it takes of a pixel follows from how far the pixel's centre is from its border.

#include "color.glsl"

flat in vec3 stroke_color;
in vec2 place;
flat in vec2 extent;

out vec4 color;

void main() {
  float from_pen = length(vec2(place.x - clamp(place.x, 0.0, extent.x), place.y));
  float covered = clamp(extent.y + 0.5 - from_pen, 0.0, 1.0);
  color = vec4(srgb(stroke_color), covered);
}
