layout(location = 0) in vec2 at;
layout(location = 1) in vec2 from_middle;
layout(location = 2) in vec4 plate_fill;
layout(location = 3) in vec4 plate_rim;
layout(location = 4) in vec4 plate_shape;

out vec2 place;  // pixels from the plate's centre
flat out vec4 fill, rim;
flat out vec4 shape;  // pixels: half width and height, corner radius, border width

void main() {
  place = from_middle;
  fill = plate_fill;
  rim = plate_rim;
  shape = plate_shape;
  gl_Position = vec4(at, 0.0, 1.0);
}
