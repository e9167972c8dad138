// Material of each kind of surface, at a point of its rest shape (metres).

// EFFECT_…: the enabled effects (client/render/effects.h).

#if defined(EFFECT_TRANSLUCENCY) && \
    (defined(SURFACE_TISSUE) || defined(SURFACE_BONE) || defined(SURFACE_SKIN) || defined(SURFACE_CLOTH))
#define SCATTERS
#endif
#if defined(SURFACE_WALL) || defined(SURFACE_FLOOR) || defined(SURFACE_CEILING) || defined(SURFACE_CLOTH)
#define MATT  // its highlight is negligible
#endif
#if defined(EFFECT_RELIEF) && (defined(SURFACE_TISSUE) || defined(SURFACE_BONE) || defined(SURFACE_SKIN) || \
                               defined(SURFACE_METAL))
#define RELIEF
#endif
#if defined(EFFECT_PARALLAX) && (defined(SURFACE_TISSUE) || defined(SURFACE_METAL))
#define PARALLAX
#endif
#if defined(WET) && defined(EFFECT_FILM)
#define FILM
#endif

struct Material {
  vec3 albedo;      // diffuse reflectance
  vec3 f0;          // specular reflectance at normal incidence
  float roughness;  // 0 mirror … 1 matt
  float film;       // 0…1: coverage by a clear film of liquid
  vec3 slope;       // RELIEF: gradient of a small relief over the surface, in the mesh's frame
  vec3 scatter;     // SCATTERS: fraction of light that wraps around the terminator, per colour channel
  vec3 glow;        // emitted radiance
#ifdef BRUSHED
  vec3 along;  // unit, in the room frame, tangent to the surface: grinding direction
#endif
};

uniform vec3 base_color;
uniform vec3 ambient;
uniform float base_roughness;
#ifdef SURFACE_GLASS
uniform vec3 refractive_index;  // for red, green, blue
#endif
uniform float wetness;

// Returns a colour factor by curvature: darker and tinted in hollows, paler on ridges.
vec3 weathered(float hollow, vec3 in_hollows, vec3 on_ridges) {
  float h = clamp(4.0 * hollow, -1.0, 1.0);
  return h > 0.0 ? mix(vec3(1.0), in_hollows, h) : mix(vec3(1.0), on_ridges, -h);
}

// `lean`: motion of the eye's ray along the surface per metre of height.
Material material_at(vec3 rest, float hollow, vec3 lean) {
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
  // Blood and fat below the capsule: bluer or yellower over some centimetres.
  vec3 b = 38.0 * rest;
  float broad = 0.5 + 0.5 * sin(b.x + 1.3 * sin(1.7 * b.y + 0.4) + 0.9 * sin(1.3 * b.z + 2.1));
  m.albedo *= mix(vec3(0.94, 0.89, 0.97), vec3(1.05, 1.07, 1.0), broad);
  m.albedo *= weathered(hollow, vec3(0.62, 0.46, 0.50), vec3(1.18, 1.25, 1.2));
  m.slope = 0.05 * field.yzw + 0.055 * lobule.yzw;
  m.scatter = vec3(0.30, 0.08, 0.06);
#elif defined(SURFACE_BONE)
  vec4 grain = noise(rest * vec3(160.0, 60.0, 160.0));
  m.albedo *= mix(vec3(0.86, 0.82, 0.74), vec3(1.06), grain.x);
  m.albedo *= weathered(hollow, vec3(0.72, 0.62, 0.46), vec3(1.05));
  m.slope = 0.03 * grain.yzw;
  m.scatter = vec3(0.10, 0.08, 0.05);
#elif defined(SURFACE_METAL)
  // Sheet metal is slightly uneven.
  const float unevenness = 0.004 / 23.0;  // m
  vec4 wear = noise(rest * 23.0);
  wear.x += dot(wear.yzw, 23.0 * (wear.x - 0.5) * unevenness * lean);
  // Steel looks darker next to white than its colour suggests. Edges and thin shafts are polished by use,
  // corners are not.
  m.f0 = base_color * dot(base_color, vec3(0.29)) * mix(0.94, 1.06, wear.x);
  m.f0 *= weathered(hollow, vec3(0.55), vec3(1.35));
  m.albedo = vec3(0.0);
  m.roughness = mix(0.45, 1.0, base_roughness);  // matt-finished: never a mirror, whatever the scene's roughness
  m.slope = 23.0 * unevenness * wear.yzw;
#ifdef BRUSHED
  // Instruments are brighter than the sheet metal below them. From a distance, grinding lines are finer than
  // a pixel.
  m.f0 = base_color * mix(0.9, 1.0, wear.x) * weathered(hollow, vec3(0.7), vec3(1.1));
  m.roughness = mix(0.28, 1.0, base_roughness);
#endif
#elif defined(SURFACE_SKIN)
  vec4 blotch = noise(rest * 70.0);
  vec4 pore = noise(rest * 900.0);
  m.albedo *= mix(vec3(1.05, 0.90, 0.88), vec3(0.98, 1.05, 1.04), blotch.x);
  m.slope = 0.035 * pore.yzw;
  m.f0 = vec3(0.028);
  m.scatter = vec3(0.28, 0.12, 0.08);
#elif defined(SURFACE_CLOTH)
  // Threads 2.5 mm apart. They fade out before they are as fine as pixels, to avoid aliasing.
  vec2 weave = 2500.0 * vec2(rest.x, rest.y + rest.z);
  vec2 finer = fwidth(weave);
  m.albedo *= 0.92 + 0.08 * (1.0 - smoothstep(0.7, 2.2, max(finer.x, finer.y))) * sin(weave.x) * sin(weave.y);
  m.scatter = vec3(0.1);
#elif defined(SURFACE_GLASS)
  m.albedo = vec3(0.0);  // unreflected light is transmitted
  m.f0 = vec3(pow((refractive_index.g - 1.0) / (refractive_index.g + 1.0), 2.0));
  m.roughness = max(base_roughness, 0.05);
#elif defined(SURFACE_WALL)
  // Paint, slightly more saturated up to hip height, above a skirting board.
  float blur = 0.5 * fwidth(rest.y) + 1e-4;
  float upper = clamp((rest.y - 1.0) / blur + 0.5, 0.0, 1.0);
  float board = 1.0 - clamp((rest.y - 0.09) / blur + 0.5, 0.0, 1.0);
  m.albedo *= mix(vec3(0.84, 0.90, 0.89), vec3(1.0), upper) * (1.0 - 0.35 * board);
#elif defined(SURFACE_CEILING)
  // Two rows of light panels, which produce the scene's ambient light.
  vec2 from_middle = abs(rest.xz - vec2(0.0, clamp(rest.z, -2.2, 2.2)));
  m.glow = ambient * (abs(from_middle.x - 1.1) < 0.3 && from_middle.y < 0.01 ? 9.0 : 1.0);
#elif defined(SURFACE_EMISSIVE)
  m.glow = base_color;
  m.albedo = vec3(0.0);
  m.f0 = vec3(0.0);
#endif
  return m;
}
