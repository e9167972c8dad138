// Linear light to what a screen shows.

// IEC 61966-2-1 to within 1 of 255 (near black 7): least squares in the root, the fourth and the eighth root,
// which cost a CPU far less than pow.
vec3 srgb(vec3 linear) {
  vec3 x = clamp(linear, 0.0, 1.0);
  vec3 r2 = sqrt(x);
  vec3 r4 = sqrt(r2);
  vec3 r8 = sqrt(r4);
  return 0.76301 * r2 + 0.55503 * r4 - 0.26668 * r8 - 0.05136 * x;
}

const float exposure = 1.15;
const float white = 3.0;  // luminance that becomes 1

// Reinhard et al. 2002, eq. 4, on luminance so that hues stay.
vec3 tone_map(vec3 radiance) {
  vec3 x = exposure * radiance;
  float luminance = max(dot(x, vec3(0.2126, 0.7152, 0.0722)), 1e-5);
  float mapped = luminance * (1.0 + luminance / (white * white)) / (1.0 + luminance);
  return x * (mapped / luminance);
}

// The radiance that is shown as `shown`: what srgb() and tone_map() do, undone.
vec3 unshown(vec3 shown) {
  vec3 x = mix(shown / 12.92, pow((shown + 0.055) / 1.055, vec3(2.4)), step(0.04045, shown));
  float mapped = max(dot(x, vec3(0.2126, 0.7152, 0.0722)), 1e-5);
  float b = 1.0 - mapped, w2 = white * white;
  float luminance = 0.5 * w2 * (sqrt(b * b + 4.0 * mapped / w2) - b);
  return x * (luminance / mapped / exposure);
}

// What a screen shows, with its brightness as alpha, by which edges are found.
vec4 with_brightness(vec3 shown) { return vec4(shown, dot(shown, vec3(0.299, 0.587, 0.114))); }
