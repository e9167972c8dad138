#include "backdrop.glsl"
#include "color.glsl"

out vec4 color;

void main() {
  vec2 at = place_in_picture();
  if (any(lessThan(at, vec2(0.0))) || any(greaterThan(at, vec2(1.0)))) discard;
  color = with_brightness(texture(picture, at).rgb);
}
