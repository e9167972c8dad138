// The cone of a spot light, from its apex to `reach`, with its base: 2 × CONE_SIDES triangles, generated
// without vertex data.

uniform mat4 clip_from_room;
uniform vec3 lamp;
uniform vec3 axis;  // unit, direction of the light
uniform float cone;  // rad, half angle
uniform float reach;  // m

out vec3 room_place;

void main() {
  int triangle = gl_VertexID / 3, corner = gl_VertexID % 3;
  int side = triangle / 2;
  bool on_base = triangle % 2 == 1;
  vec3 across = normalize(abs(axis.y) < 0.9 ? cross(axis, vec3(0.0, 1.0, 0.0)) : cross(axis, vec3(1.0, 0.0, 0.0)));
  vec3 other = cross(axis, across);
  // A little wider than the light, because a polygon is inside its circle.
  float radius = 1.02 * reach * tan(cone);
  float angle = 6.2831853 * float(side + (corner == (on_base ? 2 : 1) ? 1 : 0)) / float(CONE_SIDES);
  vec3 rim = lamp + reach * axis + radius * (cos(angle) * across + sin(angle) * other);
  room_place = corner == 0 ? (on_base ? lamp + reach * axis : lamp) : rim;
  gl_Position = clip_from_room * vec4(room_place, 1.0);
}
