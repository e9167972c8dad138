// Real objects in front of the drawn ones: shows the camera image, fading out towards the objects' borders.
#include "backdrop.glsl"

in vec3 room_place;
in vec3 room_normal;

uniform vec3 eye;

out vec4 color;

const float soft = 0.35;  // cosine of the angle between normal and view direction below which the image fades out

void main() {
  float facing = dot(normalize(room_normal), normalize(eye - room_place));
  color = vec4(texture(picture, place_in_picture()).rgb, smoothstep(0.0, soft, facing));
}
