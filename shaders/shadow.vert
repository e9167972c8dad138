layout(location = 0) in vec3 position;

uniform mat4 clip_from_mesh;
uniform vec4 kept;  // clipping plane as in main.vert, but in the mesh's frame

void main() {
  gl_ClipDistance[0] = dot(kept, vec4(position, 1.0));
  gl_Position = clip_from_mesh * vec4(position, 1.0);
}
