// A vertex of a control: its position in the frame, its texture coordinates, and its colour as displayed.

layout(location = 0) in vec2 at;
layout(location = 1) in vec2 place;
layout(location = 2) in vec4 shade;

out vec2 texture_place;
out vec4 tint;

void main() {
  texture_place = place;
  tint = shade;
  gl_Position = vec4(at, 0.0, 1.0);
}
