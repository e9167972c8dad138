layout(location = 0) in vec3 at;
layout(location = 1) in vec3 line_color;

flat out vec3 stroke_color;

void main() {
  stroke_color = line_color;
  gl_Position = vec4(at, 1.0);
}
