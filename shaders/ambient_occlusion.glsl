// Access to the depth buffer for the ambient occlusion shaders.

uniform sampler2D scene_depth;
uniform vec4 lens[1];      // 1/near, 1/far (1/m), pixels per metre at 1 m, radius of the sphere (m)
uniform vec4 viewport[1];  // x, y, width, height, in pixels

// Returns the nearness: the reciprocal of the depth along the view axis, 1/m. It is linear over the screen on
// any plane.
float nearness_at(ivec2 pixel) { return mix(lens[0].x, lens[0].y, texelFetch(scene_depth, pixel, 0).r); }

// Returns the representative pixel of a sample: the centre of COARSER × COARSER pixels, clamped to the
// viewport.
ivec2 pixel_of(ivec2 place) {
  ivec2 low = ivec2(viewport[0].xy), high = low + ivec2(viewport[0].zw) - 1;
  return clamp(COARSER * place + COARSER / 2, low, high);
}

// The tangent plane of the surface at a pixel.
struct Plane {
  ivec2 pixel;
  float nearness;
  vec2 rise;  // gradient of the nearness, per pixel
};

const float steepest = 0.02;  // relative to the nearness, per pixel: larger steps are outlines, not slopes

// Returns the smaller of the slopes to both sides, which at an outline is that of the pixel's own surface. A
// surface that is one pixel wide counts as facing the eye.
float slope(float before, float here, float after) {
  float a = here - before, b = after - here;
  float least = abs(a) < abs(b) ? a : b;
  return abs(least) < steepest * here ? least : 0.0;
}

Plane plane_at(ivec2 pixel) {
  ivec2 last = textureSize(scene_depth, 0) - 1;
  float here = nearness_at(pixel);
  return Plane(pixel, here,
               vec2(slope(nearness_at(ivec2(max(pixel.x - 1, 0), pixel.y)), here,
                          nearness_at(ivec2(min(pixel.x + 1, last.x), pixel.y))),
                    slope(nearness_at(ivec2(pixel.x, max(pixel.y - 1, 0))), here,
                          nearness_at(ivec2(pixel.x, min(pixel.y + 1, last.y))))));
}

const float off_plane = 0.012;  // relative to the nearness

// Returns 1 for a pixel in the plane, falling to 0 for nearer or farther ones. On a slanted plane the
// tolerance includes the plane's change over a pixel.
float in_plane(Plane plane, ivec2 pixel) {
  float off = nearness_at(pixel) - plane.nearness - dot(plane.rise, vec2(pixel - plane.pixel));
  float may_be_off = off_plane * plane.nearness + abs(plane.rise.x) + abs(plane.rise.y);
  return max(1.0 - abs(off) / may_be_off, 0.0);
}
