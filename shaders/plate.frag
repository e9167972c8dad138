// A rectangle with round corners and a border: the background of text over the frame.

#include "color.glsl"

in vec2 place;
flat in vec4 fill, rim;
flat in vec4 shape;

out vec4 color;

void main() {
  vec2 beyond = abs(place) - shape.xy + shape.z;
  float outside = length(max(beyond, 0.0)) + min(max(beyond.x, beyond.y), 0.0) - shape.z;
  vec4 inner = mix(rim, fill, clamp(0.5 - outside - shape.w, 0.0, 1.0));
  color = vec4(srgb(inner.rgb), inner.a * clamp(0.5 - outside, 0.0, 1.0));
}
