#include "color.glsl"

flat in vec3 stroke_color;

out vec4 color;

void main() { color = vec4(srgb(stroke_color), 1.0); }
