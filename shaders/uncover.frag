// What is real, before what was drawn: the camera's picture, less and less of it towards a rim.
#include "backdrop.glsl"

in vec3 room_place;
in vec3 room_normal;

uniform vec3 eye;

out vec4 color;

const float soft = 0.35;  // sine by which a surface faces the eye, below which it is half seen through

void main() {
  float facing = dot(normalize(room_normal), normalize(eye - room_place));
  color = vec4(texture(picture, place_in_picture()).rgb, smoothstep(0.0, soft, facing));
}
