layout(location = 0) in vec3 at;
layout(location = 1) in vec3 line_color;
layout(location = 2) in vec4 line_pen;

flat out vec3 stroke_color;
out vec2 place;        // pixels: along the stroke, across it
flat out vec2 extent;  // pixels: its length, half its width

void main() {
  stroke_color = line_color;
  place = line_pen.xy;
  extent = line_pen.zw;
  gl_Position = vec4(at, 1.0);
}
