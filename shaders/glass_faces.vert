layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;

uniform mat4 room_from_mesh;
uniform mat4 room_from_normal;
uniform mat4 clip_from_room;

out vec3 room_normal;

void main() {
  room_normal = mat3(room_from_normal) * normal;
  vec4 place = room_from_mesh * vec4(position, 1.0);
  gl_Position = clip_from_room * place;
}
