layout(location = 0) in vec4 at;
layout(location = 1) in vec3 text_color;
layout(location = 2) in vec2 sheet_place;

flat out vec3 letter_color;
out vec2 texel;

void main() {
  letter_color = text_color;
  texel = sheet_place;
  gl_Position = at;
}
