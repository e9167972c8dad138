// Conversion between linear light and display values.

// IEC 61966-2-1 to within 1 of 255 (near black 7): least squares in the square, fourth and eighth root, which
// are much cheaper than pow on a CPU.
vec3 srgb(vec3 linear) {
  vec3 x = clamp(linear, 0.0, 1.0);
  vec3 r2 = sqrt(x);
  vec3 r4 = sqrt(r2);
  vec3 r8 = sqrt(r4);
  return 0.76301 * r2 + 0.55503 * r4 - 0.26668 * r8 - 0.05136 * x;
}

const float exposure = 0.9;
const float toe = 0.137, shoulder = 0.321;

// Filmic tone mapping curve per channel, which desaturates very bright colours. Slope 1 at black, contrast in
// the middle, 0.58 at 0.5, 0.78 at 1, 0.95 at 4, and 1 only at infinity, so that nothing is clipped.
vec3 tone_map(vec3 radiance) {
  vec3 x = exposure * max(radiance, 0.0);
  return x * (x + toe) / (x * (x + shoulder) + toe);
}

// Returns the radiance for a displayed colour: the inverse of srgb() and tone_map().
vec3 unshown(vec3 shown) {
  vec3 y = mix(shown / 12.92, pow((shown + 0.055) / 1.055, vec3(2.4)), step(0.04045, shown));
  y = min(y, 0.995);
  vec3 h = toe - shoulder * y;
  return 2.0 * toe * y / (h + sqrt(h * h + 4.0 * toe * y * (1.0 - y)) + 1e-6) / exposure;
}

// Returns a displayed colour with its brightness as alpha, for the edge detection.
vec4 with_brightness(vec3 shown) { return vec4(shown, dot(shown, vec3(0.299, 0.587, 0.114))); }
