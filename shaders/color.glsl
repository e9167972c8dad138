// Linear light to what a screen shows.

// IEC 61966-2-1.
vec3 srgb(vec3 linear) {
  vec3 x = clamp(linear, 0.0, 1.0);
  return mix(12.92 * x, 1.055 * pow(max(x, 1e-5), vec3(1.0 / 2.4)) - 0.055, step(0.0031308, x));
}

// Reinhard et al. 2002, eq. 4, on luminance so that hues stay; `white` is the luminance that becomes 1.
vec3 tone_map(vec3 radiance) {
  const float exposure = 1.15;
  const float white = 3.0;
  vec3 x = exposure * radiance;
  float luminance = max(dot(x, vec3(0.2126, 0.7152, 0.0722)), 1e-5);
  float mapped = luminance * (1.0 + luminance / (white * white)) / (1.0 + luminance);
  return x * (mapped / luminance);
}
