layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;

uniform mat4 room_from_mesh;
uniform mat4 room_from_normal;
uniform mat4 clip_from_room;

out vec3 room_place;
out vec3 room_normal;

void main() {
  vec4 at = room_from_mesh * vec4(position, 1.0);
  room_place = at.xyz;
  room_normal = mat3(room_from_normal) * normal;
  gl_Position = clip_from_room * at;
}
