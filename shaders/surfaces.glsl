// What each kind of surface is made of, at a point of its rest shape (metres).

// EFFECT_…: what the picture is not spared (client/render/effects.h).

#if defined(EFFECT_TRANSLUCENCY) && \
    (defined(SURFACE_TISSUE) || defined(SURFACE_BONE) || defined(SURFACE_SKIN) || defined(SURFACE_CLOTH))
#define SCATTERS
#endif
#if defined(SURFACE_WALL) || defined(SURFACE_FLOOR)
#define IS_ROOM  // its rest shape is where it is
#endif
#if defined(SURFACE_CLOTH) || (defined(SURFACE_WALL) && (defined(PROBE) || !defined(EFFECT_REFLECTIONS)))
#define MATT  // no highlight worth its cost
#endif
#if defined(EFFECT_RELIEF) && (defined(SURFACE_TISSUE) || defined(SURFACE_BONE) || defined(SURFACE_SKIN) || \
                               defined(SURFACE_METAL) || defined(IS_ROOM))
#define RELIEF
#endif
#if defined(EFFECT_PARALLAX) && (defined(SURFACE_TISSUE) || defined(SURFACE_METAL) || defined(IS_ROOM))
#define PARALLAX
#endif
#if defined(WET) && defined(EFFECT_FILM)
#define FILM
#endif

struct Material {
  vec3 albedo;      // diffuse reflectance
  vec3 f0;          // specular reflectance at normal incidence
  float roughness;  // 0 mirror … 1 matt
  float film;       // 0…1: cover by a clear film of liquid
  vec3 slope;       // RELIEF: gradient of a small relief over the surface, in the mesh's frame
  vec3 scatter;     // SCATTERS: share of light that wraps around the terminator, by colour
  vec3 glow;        // emitted radiance
};

uniform vec3 base_color;
uniform float base_roughness;
#ifdef SURFACE_GLASS
uniform vec3 refractive_index;  // of red, green, blue
#endif
uniform float wetness;

// Square tiles of `side` metres with joints `joint` metres deep and twice as wide, whose edges are round.
struct Tile {
  float joint;  // 1 in the joints
  vec2 slope;
  vec2 cell;  // which tile it is
};

Tile tile_at(vec2 at, float side, float joint, vec2 lean) {
  vec2 blur = fwidth(at) + 1e-4;
  vec2 f = fract(at / side) - 0.5;
  vec2 distance_to_edge = (0.5 - abs(f)) * side;
  vec2 half_bevel = max(blur, vec2(0.6 * joint));
  vec2 t = clamp((distance_to_edge - joint + half_bevel) / (2.0 * half_bevel), 0.0, 1.0);
#ifdef PARALLAX
  // Through where the ray meets the tiles' height, it meets the joint's floor further on.
  vec2 low = 1.0 - t * t * (3.0 - 2.0 * t);
  at -= max(low.x, low.y) * joint * lean;
  f = fract(at / side) - 0.5;
  distance_to_edge = (0.5 - abs(f)) * side;
  t = clamp((distance_to_edge - joint + half_bevel) / (2.0 * half_bevel), 0.0, 1.0);
#endif
  vec2 inside = t * t * (3.0 - 2.0 * t);
  // Far away a joint is thinner than a pixel: fade it into its average.
  float fade = clamp(4.0 * joint / max(blur.x, blur.y), 0.0, 1.0);
  Tile tile;
  tile.joint = (1.0 - inside.x * inside.y) * fade;
  tile.slope = -fade * joint * sign(f) * 3.0 * t * (1.0 - t) / half_bevel * inside.yx;
  tile.cell = floor(at / side);
  return tile;
}

// No two tiles lie quite level.
vec2 tilt_of(vec2 cell) {
  uvec3 p = uvec3(ivec3(cell.x, cell.y, 3));
  return 0.012 * (vec2(lattice(p), lattice(p + uvec3(0, 0, 5))) - 0.5);
}

// `lean`: of the eye's ray, metres along the surface for each metre of height.
Material material_at(vec3 rest, vec3 lean) {
  Material m;
  m.albedo = base_color;
  m.f0 = vec3(0.04);
  m.roughness = base_roughness;
  m.film = wetness;
  m.slope = vec3(0.0);
  m.scatter = vec3(0.0);
  m.glow = vec3(0.0);

#if defined(SURFACE_TISSUE)
  // Lobules of some millimetres in fields of some centimetres.
  const float field_height = 0.05 / 55.0;  // m
  vec4 field = noise(rest * 55.0);
  vec3 shift = (field.x - 0.5) * field_height * lean;
  field.x += dot(field.yzw, 55.0 * shift);
  vec4 lobule = noise((rest + shift) * 260.0);
  m.albedo *= mix(vec3(0.72, 0.62, 0.64), vec3(1.18, 1.2, 1.16), 0.6 * field.x + 0.4 * lobule.x);
  m.slope = 0.05 * field.yzw + 0.055 * lobule.yzw;
  m.scatter = vec3(0.30, 0.08, 0.06);
#elif defined(SURFACE_BONE)
  vec4 grain = noise(rest * vec3(160.0, 60.0, 160.0));
  m.albedo *= mix(vec3(0.86, 0.82, 0.74), vec3(1.06), grain.x);
  m.slope = 0.03 * grain.yzw;
  m.scatter = vec3(0.10, 0.08, 0.05);
#elif defined(SURFACE_METAL)
  // Sheet is never quite even.
  const float unevenness = 0.006 / 23.0;  // m
  vec4 wear = noise(rest * 23.0);
  wear.x += dot(wear.yzw, 23.0 * (wear.x - 0.5) * unevenness * lean);
  m.f0 = base_color;
  m.albedo = vec3(0.0);
  m.roughness = clamp(base_roughness * mix(0.93, 1.07, wear.x), 0.05, 1.0);
  m.slope = 23.0 * unevenness * wear.yzw;
#elif defined(SURFACE_SKIN)
  vec4 blotch = noise(rest * 70.0);
  vec4 pore = noise(rest * 900.0);
  m.albedo *= mix(vec3(1.05, 0.90, 0.88), vec3(0.98, 1.05, 1.04), blotch.x);
  m.slope = 0.035 * pore.yzw;
  m.f0 = vec3(0.028);
  m.scatter = vec3(0.28, 0.12, 0.08);
#elif defined(SURFACE_CLOTH)
  vec3 weave = 900.0 * rest;
  m.albedo *= 0.92 + 0.08 * sin(weave.x) * sin(weave.y + weave.z);
  m.scatter = vec3(0.1);
#elif defined(SURFACE_GLASS)
  m.albedo = vec3(0.0);  // what isn't mirrored goes through
  m.f0 = vec3(pow((refractive_index.g - 1.0) / (refractive_index.g + 1.0), 2.0));
  m.roughness = max(base_roughness, 0.05);
#elif defined(SURFACE_FLOOR)
  Tile tile = tile_at(rest.xz, 0.4, 0.003, lean.xz);
  m.albedo *= mix(0.9, 1.05, lattice(uvec3(ivec3(tile.cell.x, tile.cell.y, 7)))) * mix(1.0, 0.6, tile.joint);
  m.roughness = mix(m.roughness, 0.9, tile.joint);
  vec2 slope = tile.slope + tilt_of(tile.cell);
  m.slope = vec3(slope.x, 0.0, slope.y);
#elif defined(SURFACE_WALL)
  // Tiles up to the height of a door, paint above. One of x and z is constant over a wall.
  Tile tile = tile_at(vec2(rest.x + rest.z, rest.y), 0.25, 0.0025, vec2(lean.x + lean.z, lean.y));
  bool is_tiled = rest.y < 2.0;
  m.albedo *= is_tiled ? mix(1.0, 0.72, tile.joint) : 1.12;
  m.roughness = is_tiled ? mix(0.3, 0.9, tile.joint) : 0.9;
  vec2 slope = tile.slope + tilt_of(tile.cell);
  m.slope = is_tiled ? vec3(slope.x, slope.y, slope.x) : vec3(0.0);
#elif defined(SURFACE_EMISSIVE)
  m.glow = base_color;
  m.albedo = vec3(0.0);
  m.f0 = vec3(0.0);
#endif
  return m;
}
