// Value noise on the integer lattice, with its gradient.

float lattice(uvec3 p) {
  uint h = p.x * 0x9e3779b1u ^ p.y * 0x85ebca77u ^ p.z * 0xc2b2ae3du;
  h = (h ^ (h >> 15)) * 0x2c1b3c6du;
  h ^= h >> 13;
  return float(h & 0xffffu) / 65535.0;
}

// x: value in 0…1; yzw: gradient per unit of `at`. Quintic fade, so the gradient is smooth too.
vec4 noise(vec3 at) {
  vec3 cell = floor(at);
  vec3 f = at - cell;
  uvec3 p = uvec3(ivec3(cell));
  vec3 u = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
  vec3 du = 30.0 * f * f * (f * (f - 2.0) + 1.0);
  float a = lattice(p);
  float b = lattice(p + uvec3(1, 0, 0));
  float c = lattice(p + uvec3(0, 1, 0));
  float d = lattice(p + uvec3(1, 1, 0));
  float e = lattice(p + uvec3(0, 0, 1));
  float g = lattice(p + uvec3(1, 0, 1));
  float h = lattice(p + uvec3(0, 1, 1));
  float k = lattice(p + uvec3(1, 1, 1));
  float k0 = a, k1 = b - a, k2 = c - a, k3 = e - a;
  float k4 = a - b - c + d, k5 = a - c - e + h, k6 = a - b - e + g;
  float k7 = -a + b + c - d + e - g - h + k;
  float value = k0 + k1 * u.x + k2 * u.y + k3 * u.z + k4 * u.x * u.y + k5 * u.y * u.z + k6 * u.z * u.x +
                k7 * u.x * u.y * u.z;
  vec3 gradient = du * vec3(k1 + k4 * u.y + k6 * u.z + k7 * u.y * u.z,
                            k2 + k5 * u.z + k4 * u.x + k7 * u.z * u.x,
                            k3 + k6 * u.x + k5 * u.y + k7 * u.x * u.y);
  return vec4(value, gradient);
}
