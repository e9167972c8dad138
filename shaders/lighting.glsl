// Light that a point sends to the eye: GGX specular (Walter et al. 2007) with Schlick's Fresnel term, Lambert
// diffuse, a clear film on top where it is wet, and one shadow map.

const float pi = 3.14159265;
const int max_lights = 16;

// The renderer defines EACH_LIGHT(DO) as DO(index, kind, has_shadow) for each light: software rasterisers gather
// from arrays at variable indices and run both sides of branches, which costs several times the shading itself.
const int directional_light = 0;
const int spot_light = 2;

uniform vec4 light_position[max_lights];
uniform vec4 light_direction[max_lights];  // w: cosine of a spot's half angle
uniform vec4 light_color[max_lights];      // w: cosine inside which a spot is at full strength
uniform vec3 ambient;

uniform sampler2DShadow shadow_map;
uniform mat4 shadow_clip_from_room;
uniform float shadow_texel;

float schlick(float cosine) {
  float x = clamp(1.0 - cosine, 0.0, 1.0);
  float x2 = x * x;
  return x2 * x2 * x;
}

// Distribution times visibility (height-correlated Smith, Heitz 2014, in Hammon's 2017 approximation).
float ggx(float ndl, float ndv, float ndh, float roughness) {
  float a = max(roughness * roughness, 0.002);
  float d = ndh * ndh * (a * a - 1.0) + 1.0;
  float visibility = 0.5 / mix(2.0 * ndl * ndv, ndl + ndv, a);
  return a * a / (pi * d * d) * visibility;
}

// A bright ceiling over a dim floor.
vec3 surroundings(vec3 direction) { return ambient * mix(0.45, 1.9, smoothstep(-0.4, 0.9, direction.y)); }

float shadow_at(vec3 place, vec3 normal, float distance_to_light) {
  // Move off the surface by about a texel, so that it does not shade itself.
  vec4 clip = shadow_clip_from_room * vec4(place + normal * (2.0 * shadow_texel * distance_to_light), 1.0);
  vec3 at = clip.xyz / clip.w * 0.5 + 0.5;
  if (clip.w <= 0.0 || at.z >= 1.0 || any(lessThan(at.xy, vec2(0.0))) || any(greaterThan(at.xy, vec2(1.0))))
    return 1.0;
  float step_size = 1.2 / float(textureSize(shadow_map, 0).x);
  float sum = texture(shadow_map, at);
  sum += texture(shadow_map, at + vec3(step_size, 0.35 * step_size, 0.0));
  sum += texture(shadow_map, at + vec3(-0.35 * step_size, step_size, 0.0));
  sum += texture(shadow_map, at + vec3(-step_size, -0.35 * step_size, 0.0));
  sum += texture(shadow_map, at + vec3(0.35 * step_size, -step_size, 0.0));
  return 0.2 * sum;
}

// Towards the light, and what arrives from there. A point or spot light of intensity 1 lights a surface that
// faces it at 1 m as a directional light of intensity 1 does.
vec3 arriving(const int k, const int kind, const bool has_shadow, vec3 place, vec3 normal, out vec3 towards) {
  if (kind == directional_light) {
    towards = -light_direction[k].xyz;
    return light_color[k].rgb;
  }
  vec3 offset = light_position[k].xyz - place;
  float squared = max(dot(offset, offset), 1e-4);
  towards = offset * inversesqrt(squared);
  vec3 light = light_color[k].rgb / squared;
  if (kind == spot_light) {
    float cosine = dot(-towards, light_direction[k].xyz);
    light *= smoothstep(light_direction[k].w, light_color[k].w, cosine);
  }
  if (has_shadow) light *= shadow_at(place, normal, sqrt(squared));
  return light;
}

// A surface under its film, as seen by the eye.
struct Facing {
  vec3 normal, film_normal, view;
  float ndv, film_ndv;
  vec3 wet_albedo;
};

const float film_f0 = 0.025;
const float film_roughness = 0.16;

// Adds what one light sends to the eye by the surface, and by its film.
void add_light(vec3 light, vec3 towards, Material m, Facing s, inout vec3 base, inout vec3 film) {
  vec3 halfway = normalize(towards + s.view);
  float raw = dot(s.normal, towards);
  float ndl = max(raw, 0.0);
  float f = schlick(dot(s.view, halfway));
  vec3 wrapped = max((vec3(raw) + m.scatter) / ((1.0 + m.scatter) * (1.0 + m.scatter)), 0.0);
  vec3 specular = (m.f0 + (1.0 - m.f0) * f) *
                  (ggx(ndl, s.ndv, max(dot(s.normal, halfway), 0.0), m.roughness) * pi * ndl);
  base += light * (s.wet_albedo * wrapped + specular);
  float film_ndl = max(dot(s.film_normal, towards), 0.0);
  film += light * (m.film * (film_f0 + (1.0 - film_f0) * f) * pi * film_ndl *
                   ggx(film_ndl, s.film_ndv, max(dot(s.film_normal, halfway), 0.0), film_roughness));
}

// `film_normal` is smoother: the film fills the relief.
vec3 shade(Material m, vec3 place, vec3 normal, vec3 film_normal, vec3 view) {
  Facing s;
  s.normal = normal;
  s.film_normal = film_normal;
  s.view = view;
  s.ndv = max(dot(normal, view), 1e-3);
  s.film_ndv = max(dot(film_normal, view), 1e-3);
  s.wet_albedo = m.albedo * mix(1.0, 0.82, m.film);  // light lost to total reflection inside the film
  float film_fresnel = m.film * (film_f0 + (1.0 - film_f0) * schlick(s.film_ndv));

  vec3 fresnel = m.f0 + (1.0 - m.f0) * schlick(s.ndv) * (1.0 - m.roughness);
  vec3 mirrored = surroundings(reflect(-view, normal));
  vec3 base = s.wet_albedo * surroundings(normal) + fresnel * mirrored;
  vec3 film = film_fresnel * surroundings(reflect(-view, film_normal));

  vec3 towards, light;
#define ADD_LIGHT(K, KIND, HAS_SHADOW)                                    \
  light = arriving(K, KIND, HAS_SHADOW, place, film_normal, towards);     \
  add_light(light, towards, m, s, base, film);
  EACH_LIGHT(ADD_LIGHT)
  return base * (1.0 - film_fresnel) + film + m.glow;
}
