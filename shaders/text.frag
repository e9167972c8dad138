// A glyph: the covered part of a pixel, read from a coverage image or computed from a distance field. Without
// lighting.

#include "color.glsl"

uniform sampler2D sheet;
uniform float distance_reach;  // pixels of the sheet: range of the distances

flat in vec3 letter_color;
in vec2 texel;

out vec4 color;

void main() {
  float on_sheet = texture(sheet, texel / vec2(textureSize(sheet, 0))).r;
#ifdef DISTANCES
  // Green 2007: distance fields stay sharp at any magnification. The pixel size is the side of a square with
  // the pixel's area on the sheet.
  vec2 dx = dFdx(texel), dy = dFdy(texel);
  float pixel = sqrt(max(abs(dx.x * dy.y - dx.y * dy.x), 1e-6));
  float inside = (on_sheet - 128.0 / 255.0) * (255.0 / 127.0) * distance_reach;
  float covered = clamp(inside / pixel + 0.5, 0.0, 1.0);
#else
  float covered = on_sheet;
#endif
  color = vec4(srgb(letter_color), covered);
}
