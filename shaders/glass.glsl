// Refraction by a layer of glass (Wyman 2005), for client/render/glass_pass.*.

uniform vec3 transmittance;  // through 10 mm

// Returns the reflectance of a smooth surface for unpolarised light (Fresnel); `index`: refractive index of
// the far side relative to the near side.
float fresnel(float cosine, float index) {
  float g2 = index * index - 1.0 + cosine * cosine;
  if (g2 <= 0.0) return 1.0;
  float g = sqrt(g2);
  float a = (g - cosine) / (g + cosine);
  float b = (cosine * (g + cosine) - 1.0) / (cosine * (g - cosine) + 1.0);
  return 0.5 * a * a * (1.0 + b * b);
}

#if defined(REFRACTS)
uniform sampler2D picture;
uniform sampler2D scene_depth;
uniform sampler2D front_depth;
uniform sampler2D back_depth;
uniform sampler2D back_normals;
uniform mat4 clip_from_room;
uniform mat4 room_from_clip;
uniform vec4 viewport[1];  // x, y, width, height, in pixels

vec2 pixel_of(vec3 place) {
  vec4 clip = clip_from_room * vec4(place, 1.0);
  return viewport[0].xy + (0.5 + 0.5 * clip.xy / clip.w) * viewport[0].zw;
}

bool is_seen(vec2 pixel) {
  vec2 at = pixel - viewport[0].xy;
  return at.x > 0.0 && at.y > 0.0 && at.x < viewport[0].z && at.y < viewport[0].w;
}

vec3 place_at(vec2 pixel, float depth) {
  vec3 clip = vec3((pixel - viewport[0].xy) / viewport[0].zw, depth) * 2.0 - 1.0;
  vec4 place = room_from_clip * vec4(clip, 1.0);
  return place.xyz / place.w;
}

vec3 scene_at(vec2 pixel) { return place_at(pixel, texelFetch(scene_depth, ivec2(pixel), 0).r); }

// Returns the radiance along a ray from `from`: that of the frame where the ray meets it, or else the
// environment map.
vec3 met(vec3 from, vec3 ray) {
  float reach = length(scene_at(pixel_of(from)) - from);
  vec2 pixel = pixel_of(from + reach * ray);
  if (!is_seen(pixel)) return mirrored(ray, 0.0);
  reach = length(scene_at(pixel) - from);
  pixel = pixel_of(from + reach * ray);
  if (!is_seen(pixel)) return mirrored(ray, 0.0);
  // Points in front of the glass are not refracted by it.
  if (dot(scene_at(pixel) - from, ray) < -0.003) pixel = gl_FragCoord.xy;
  return unshown(texture(picture, pixel / vec2(textureSize(picture, 0))).rgb);
}

// Returns the light of one refractive index that passes through the layer.
vec3 through(vec3 place, vec3 normal, vec3 view, float index) {
  ivec2 here = ivec2(gl_FragCoord.xy);
  vec3 inside = refract(-view, normal, 1.0 / index);
  vec3 back = place_at(gl_FragCoord.xy, min(texelFetch(back_depth, here, 0).r, texelFetch(scene_depth, here, 0).r));
  float thickness = length(back - place);
  vec3 outward = inside;
  // Newton's method for the exit point, starting from the back face drawn at the pixel of the estimated exit.
  for (int k = 0; k < 2; ++k) {
    vec2 pixel = pixel_of(place + thickness * inside);
    vec4 face = is_seen(pixel) ? texelFetch(back_normals, ivec2(pixel), 0) : vec4(0.0);
    if (face.a == 0.0) break;
    outward = normalize(face.xyz);
    float steep = dot(outward, inside);
    if (steep < 0.2) break;
    vec3 there = place_at(pixel, texelFetch(back_depth, ivec2(pixel), 0).r);
    thickness = clamp(dot(there - place, outward) / steep, 0.3 * thickness, 2.0 * thickness);
  }
  vec3 leaves = place + thickness * inside;
  // Seen from inside, a back face's normal points along the ray.
  float cosine = max(dot(outward, inside), 0.0);
  float kept = fresnel(cosine, 1.0 / index);
  vec3 ray = refract(inside, -outward, index);
  vec3 light = vec3(0.0);
  if (kept < 1.0) light += (1.0 - kept) * met(leaves, ray);
  if (kept > 0.02) light += kept * mirrored(reflect(inside, outward), 0.0);
  return light * pow(transmittance, vec3(thickness / 0.010));
}

vec3 transmitted(vec3 place, vec3 normal, vec3 view) {
#ifdef EFFECT_DISPERSION
  return vec3(through(place, normal, view, refractive_index.r).r, through(place, normal, view, refractive_index.g).g,
              through(place, normal, view, refractive_index.b).b);
#else
  return through(place, normal, view, refractive_index.g);
#endif
}

// Returns whether the fragment belongs to another layer of glass, which is drawn separately.
bool is_other_layer() { return abs(gl_FragCoord.z - texelFetch(front_depth, ivec2(gl_FragCoord.xy), 0).r) > 1e-6; }
#endif
