#include "color.glsl"

flat in vec3 stroke_color;

out vec4 color;

void main() { color = with_brightness(srgb(stroke_color)); }
