// A corner of a control: where it is on the picture, in a texture, and its colour as the screen shows it.

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
