// Depth and normals of glass, one layer of faces at a time (Everitt 2001: depth peeling).

uniform sampler2D nearer;  // faces up to this depth are skipped
uniform sampler2D scene_depth;
uniform int is_peeled;
uniform int is_hidden;  // 1: faces behind the scene's depth are skipped

in vec3 room_normal;
out vec4 normal;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  if (is_peeled == 1 && gl_FragCoord.z <= texelFetch(nearer, at, 0).r) discard;
  if (is_hidden == 1 && gl_FragCoord.z >= texelFetch(scene_depth, at, 0).r) discard;
  normal = vec4(normalize(room_normal), 1.0);
}
