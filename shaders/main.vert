layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 rest;

uniform mat4 room_from_mesh;
uniform mat4 clip_from_room;

out vec3 room_place;
out vec3 room_normal;
out vec3 rest_place;

void main() {
  vec4 place = room_from_mesh * vec4(position, 1.0);
  room_place = place.xyz;
  room_normal = mat3(room_from_mesh) * normal;
  rest_place = rest;
  gl_Position = clip_from_room * place;
}
