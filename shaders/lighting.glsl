// Radiance from a point to the eye: GGX specular (Walter et al. 2007) with Schlick's Fresnel term, Lambert
// diffuse, a clear film on top if wet (FILM), and one shadow map.
//
// EACH_LIGHT(X) is X(0, kind) X(1, kind) …, with kind 0 directional, 1 point, 2 spot. SHADOW_LIGHT is the
// light with the shadow map, −1 for none. Both are compiled for the scene, because on a CPU a branch costs
// both its sides.

const int max_lights = 16;

uniform vec4 light_position[max_lights];
uniform vec4 light_direction[max_lights];  // w: cosine of a spot's half angle
uniform vec4 light_color[max_lights];      // w: cosine of the angle within which a spot has full strength

#if SHADOW_LIGHT >= 0
uniform sampler2D shadow_map;  // depth; its outermost texels are lit
uniform float shadow_size;     // texels, width and height
in vec4 shadow_place;
#endif

const float film_f0 = 0.025;
const float film_roughness = 0.20;
const float lamp_radius = 0.15;  // m: point and spot lights are disks, so that highlights have a width

float schlick(float cosine) {
  float x = clamp(1.0 - cosine, 0.0, 1.0);
  float x2 = x * x;
  return x2 * x2 * x;
}

// Returns π times distribution times visibility (height-correlated Smith, Heitz 2014, in Hammon's 2017
// approximation). `width` is added to the squared roughness: half of the light's radius over its distance
// (Karis 2013).
float ggx(float ndl, float ndv, float ndh, float roughness, float width) {
  float a = min(max(roughness * roughness, 0.002) + width, 1.0);
  float d = ndh * ndh * (a * a - 1.0) + 1.0;
  return 0.5 * a * a / (d * d * mix(2.0 * ndl * ndv, ndl + ndv, a));
}

#ifdef BRUSHED
// Brushed metal reflects sharply along the grinding direction and broadly across it: anisotropic GGX with one
// width per direction (Burley 2012). `along`: unit, tangent to the surface.
const float across_grinding = 2.4;  // factor of the squared roughness; its reciprocal applies along the axis

float brushed_ggx(float ndl, float ndv, vec3 halfway, vec3 normal, vec3 along, float roughness, float width) {
  float a = max(roughness * roughness, 0.002);
  vec2 w = min(vec2(a / across_grinding, a * across_grinding) + width, 1.0);
  vec2 h = vec2(dot(halfway, along), dot(halfway, cross(normal, along))) / w;
  float ndh = dot(halfway, normal);
  float d = dot(h, h) + ndh * ndh;
  return 0.5 / (w.x * w.y * d * d * mix(2.0 * ndl * ndv, ndl + ndv, sqrt(w.x * w.y)));
}

// Returns the normal for reflections of the room in brushed metal. It is bent towards the eye across the
// grinding direction, because the reflection is spread there.
vec3 bent_normal(vec3 normal, vec3 along, vec3 view) {
  vec3 across = view - dot(view, along) * along;
  return normalize(mix(normal, normalize(across + 1e-4 * normal), 0.35));
}
#endif

#ifdef PROBE
// Ambient light from a bright ceiling over a dim floor.
vec3 surroundings(vec3 normal) {
  float t = clamp(0.77 * normal.y + 0.31, 0.0, 1.0);
  return ambient * (0.45 + 1.45 * t * t * (3.0 - 2.0 * t));
}
#else
// Irradiance as spherical harmonics up to the second order (Ramamoorthi and Hanrahan 2001), with the
// coefficients of the normal's products (client/render/irradiance.h).
uniform vec4 irradiance[9];

vec3 surroundings(vec3 n) {
  vec3 sum = irradiance[0].rgb + n.x * irradiance[1].rgb + n.y * irradiance[2].rgb + n.z * irradiance[3].rgb;
  sum += n.x * n.y * irradiance[4].rgb + n.y * n.z * irradiance[5].rgb + n.z * n.x * irradiance[6].rgb;
  sum += n.y * n.y * irradiance[7].rgb + (n.x * n.x - n.z * n.z) * irradiance[8].rgb;
  return max(sum, 0.0);
}
#endif

// Texels of the environment map hold the square root of a quarter of the radiance.
vec3 encoded(vec3 radiance) { return sqrt(clamp(0.25 * radiance, 0.0, 1.0)); }

// Returns the reflection of the room, blurred by roughness.
#if defined(EFFECT_REFLECTIONS) && !defined(PROBE)
uniform samplerCube environment_map;

vec3 mirrored(vec3 direction, float roughness) {
  vec3 root = textureLod(environment_map, direction, 6.0 * roughness).rgb;
  return 4.0 * root * root;
}
#else
vec3 mirrored(vec3 direction, float roughness) { return surroundings(direction); }
#endif

#if SHADOW_LIGHT >= 0
float lit(ivec2 texel, float depth) { return depth <= texelFetch(shadow_map, texel, 0).r ? 1.0 : 0.0; }

vec3 lit_row(ivec2 middle, float depth) {
  return vec3(lit(middle - ivec2(1, 0), depth), lit(middle, depth), lit(middle + ivec2(1, 0), depth));
}

// Returns the unshadowed fraction of the light: 3 × 3 texels, weighted by a tent two texels wide. Texels are
// fetched and compared here, because a comparison sampler is slower on a CPU.
float shadow_at(vec4 clip) {
  vec3 at = clip.xyz / clip.w * 0.5 + 0.5;
  at.z = min(at.z, 1.0);
  vec2 texel = clamp(at.xy * shadow_size - 0.5, 1.0, shadow_size - 2.0);
  vec2 middle = floor(texel + 0.5);
  vec2 f = texel - middle + 0.5;
  ivec2 m = ivec2(middle);
  vec3 rows = (1.0 - f.y) * lit_row(m - ivec2(0, 1), at.z) + lit_row(m, at.z) +
              f.y * lit_row(m + ivec2(0, 1), at.z);
  return 0.25 * dot(rows, vec3(1.0 - f.x, 1.0, f.x));
}
#endif

// Computes the direction to the light and the irradiance from it, without shadows. A point or spot light of
// intensity 1 lights a facing surface at 1 m like a directional light of intensity 1. `width`: the light's
// angular width as used by ggx().
vec3 sent(int k, int kind, vec3 place, out vec3 towards, out float width) {
  if (kind == 0) {
    towards = -light_direction[k].xyz;
    width = 0.0;
    return light_color[k].rgb;
  }
  vec3 offset = light_position[k].xyz - place;
  float squared = max(dot(offset, offset), 1e-4);
  float inverse = inversesqrt(squared);
  towards = offset * inverse;
  width = 0.5 * lamp_radius * inverse;
  vec3 light = light_color[k].rgb * (inverse * inverse);
  if (kind == 2) {
    float cosine = -dot(towards, light_direction[k].xyz);
    light *= smoothstep(light_direction[k].w, light_color[k].w, cosine);
  }
  return light;
}

float unshadowed(int k) {
#if SHADOW_LIGHT >= 0
  if (k == SHADOW_LIGHT) return shadow_at(shadow_place);
#endif
  return 1.0;
}

vec3 arriving(int k, int kind, vec3 place, out vec3 towards, out float width) {
  vec3 light = sent(k, kind, place, towards, width);
  return unshadowed(k) * light;
}

#ifdef GROUND
void add_share(inout vec3 all, inout vec3 left, int k, int kind, vec3 place, vec3 normal) {
  vec3 towards;
  float width;
  vec3 light = sent(k, kind, place, towards, width);
  light *= max(dot(normal, towards), 0.0);
  all += light;
  left += unshadowed(k) * light;
}

// Returns the fraction of the light on a point that shadows leave.
vec3 share_of_light(vec3 place, vec3 normal) {
  vec3 all = surroundings(normal);
  vec3 left = all;
#define ADD_SHARE(K, KIND) add_share(all, left, K, KIND, place, normal);
  EACH_LIGHT(ADD_SHARE)
  return left / max(all, vec3(1e-6));
}
#endif

struct Radiance {
  vec3 base;
  vec3 film;
};

void add_light(inout Radiance sum, int k, int kind, Material m, vec3 place, vec3 normal, vec3 film_normal,
               vec3 view, float ndv, float film_ndv) {
  vec3 towards;
  float width;
  vec3 light = arriving(k, kind, place, towards, width);
  float raw = dot(normal, towards);
  float ndl = max(raw, 0.0);
  // Products with the half vector between light and eye, without computing the vector.
  float ldv = dot(towards, view);
  float inverse = inversesqrt(max(2.0 + 2.0 * ldv, 1e-4));
  float ndh = max((raw + ndv) * inverse, 0.0);
  float f = schlick((1.0 + ldv) * inverse);
#ifdef SCATTERS
  vec3 diffuse = m.albedo * max((vec3(raw) + m.scatter) / ((1.0 + m.scatter) * (1.0 + m.scatter)), 0.0);
#else
  vec3 diffuse = m.albedo * ndl;
#endif
#ifdef MATT
  sum.base += light * diffuse;
#elif defined(BRUSHED)
  vec3 halfway = (towards + view) * inverse;
  float shine = brushed_ggx(ndl, ndv, halfway, normal, m.along, m.roughness, width) * ndl;
  sum.base += light * ((m.f0 + (1.0 - m.f0) * f) * shine);
#else
  sum.base += light * (diffuse + (m.f0 + (1.0 - m.f0) * f) * (ggx(ndl, ndv, ndh, m.roughness, width) * ndl));
#endif
#ifdef FILM
  float film_raw = dot(film_normal, towards);
  float film_ndl = max(film_raw, 0.0);
  float film_ndh = max((film_raw + film_ndv) * inverse, 0.0);
  sum.film += light * (m.film * (film_f0 + (1.0 - film_f0) * f) * film_ndl *
                       ggx(film_ndl, film_ndv, film_ndh, film_roughness, width));
#endif
}

// `film_normal`: normal of the film, which fills the relief.
vec3 shade(Material m, vec3 place, vec3 normal, vec3 film_normal, vec3 view) {
  float ndv = max(dot(normal, view), 1e-3);
  float film_ndv = max(dot(film_normal, view), 1e-3);
#ifdef FILM
  m.albedo *= mix(1.0, 0.82, m.film);  // light lost to total reflection inside the film
  float film_fresnel = m.film * (film_f0 + (1.0 - film_f0) * schlick(film_ndv));
#endif
  Radiance sum = Radiance(m.albedo * surroundings(normal), vec3(0.0));
#ifndef MATT
  vec3 fresnel = m.f0 + (1.0 - m.f0) * schlick(ndv) * (1.0 - m.roughness);
#ifdef BRUSHED
  vec3 facet = bent_normal(normal, m.along, view);
#else
  vec3 facet = normal;
#endif
  sum.base += fresnel * mirrored(2.0 * max(dot(facet, view), 1e-3) * facet - view, m.roughness);
#endif
#ifdef FILM
  sum.film = film_fresnel * mirrored(2.0 * film_ndv * film_normal - view, film_roughness);
#endif

#define ADD_LIGHT(K, KIND) add_light(sum, K, KIND, m, place, normal, film_normal, view, ndv, film_ndv);
  EACH_LIGHT(ADD_LIGHT)

#ifdef FILM
  sum.base = sum.base * (1.0 - film_fresnel) + sum.film;
#endif
  return sum.base + m.glow;
}
