#include "color.glsl"
#include "noise.glsl"
#include "surfaces.glsl"
#include "lighting.glsl"

in vec3 room_place;
in vec3 room_normal;
in vec3 rest_place;
in float hollowness;  // −1 on ridges … 1 in hollows (client/render/hollows.h)

uniform mat4 room_from_mesh;
uniform vec3 eye;
uniform float brightness;
uniform float opacity;  // CLEAR: at normal incidence
#ifdef BRUSHED
uniform vec3 long_axis;  // in the mesh's frame
#endif

out vec4 color;

#ifdef SURFACE_GLASS
#include "glass.glsl"
#endif

// Returns how far the eye's ray moves along the surface, in the rest shape, per metre of height (Welsh 2004:
// parallax mapping with its offset limited). The rest shape of a deformed body follows from the differences
// between neighbouring pixels.
vec3 lean(vec3 towards_eye, vec3 normal) {
#ifdef PARALLAX
  vec3 along = towards_eye - dot(towards_eye, normal) * normal;
  vec3 px = dFdx(room_place), py = dFdy(room_place);
  float xx = dot(px, px), xy = dot(px, py), yy = dot(py, py);
  float x = dot(along, px), y = dot(along, py);
  float determinant = max(xx * yy - xy * xy, 0.02 * xx * yy);
  return ((yy * x - xy * y) * dFdx(rest_place) + (xx * y - xy * x) * dFdy(rest_place)) / determinant;
#else
  return vec3(0.0);
#endif
}

void main() {
  vec3 smooth_normal = normalize(room_normal);
#ifdef SHAFT
  // Light shaft: the eye looks through much dust in the middle, and through little at the border.
  float through = abs(dot(smooth_normal, normalize(eye - room_place)));
  float left = mix(1.0, 0.5, rest_place.x) * (1.0 - smoothstep(0.85, 1.0, rest_place.x));
  color = with_brightness(brightness * base_color * through * through * left);
#elif defined(GROUND)
  // Multiplied with the camera image, which has the same encoding: for a power law, products are preserved.
  color = with_brightness(srgb(share_of_light(room_place, smooth_normal)));
#elif defined(PAINTED)
  // Lit from the eye only and without tone mapping, so that colours match the legend.
  float facing = abs(dot(smooth_normal, normalize(eye - room_place)));
  color = with_brightness(srgb(mix(0.45, 1.0, facing) * rest_place));
#else
  vec3 towards_eye = normalize(eye - room_place);
  Material material = material_at(rest_place, hollowness, lean(towards_eye, smooth_normal));
  vec3 normal = smooth_normal;
  vec3 film_normal = smooth_normal;
#ifdef RELIEF
  vec3 slope = mat3(room_from_mesh) * material.slope;
  normal = normalize(smooth_normal - (slope - dot(slope, smooth_normal) * smooth_normal));
  film_normal = normalize(normal + smooth_normal);
#endif
#ifdef BRUSHED
  // The offset gives a direction where the surface is perpendicular to the axis.
  vec3 along = mat3(room_from_mesh) * long_axis + vec3(1e-3, 2e-3, 1e-3);
  material.along = normalize(along - dot(along, normal) * normal);
#endif
  vec3 radiance = shade(material, room_place, normal, film_normal, towards_eye);
#ifdef SURFACE_GLASS
  // shade() includes the reflection; the rest is transmitted.
  float passes = 1.0 - fresnel(max(dot(normal, towards_eye), 0.0), refractive_index.g);
#ifdef REFRACTS
  if (is_other_layer()) discard;
  radiance += passes * transmitted(room_place, normal, towards_eye);
  color = with_brightness(srgb(tone_map(brightness * radiance)));
#else
  // Blended over the background, whose transmitted fraction is the alpha.
  color = vec4(srgb(tone_map(brightness * radiance)), passes * dot(transmittance, vec3(1.0 / 3.0)));
#endif
#elif defined(PROBE)
  color = vec4(encoded(radiance), 1.0);
#else
  color = with_brightness(srgb(tone_map(brightness * radiance)));
#endif
#endif
#ifdef CLEAR
  // Opacity of a shell by Beer's law: it grows with the length of the oblique path through it.
  float facing_eye = abs(dot(smooth_normal, normalize(eye - room_place)));
  color.a = 1.0 - pow(1.0 - opacity, 1.0 / max(facing_eye, 0.2));
#endif
}
