// Antialiasing of a finished frame (after Lottes 2009). Follows the border between two rows of pixels to both
// its ends; the nearer end determines how much of this pixel is beyond the border. Pixels that are not at an
// edge are unchanged; blocks of such pixels cost a CPU little.

uniform sampler2D picture;  // alpha: perceived brightness

out vec4 color;

const float least_contrast = 0.035;
const int most_steps = 8;

void main() {
  vec2 pixel = 1.0 / vec2(textureSize(picture, 0));
  ivec2 last = textureSize(picture, 0) - 1;
  ivec2 at = ivec2(gl_FragCoord.xy);
  ivec2 low = max(at - 1, 0), high = min(at + 1, last);
  float here = texelFetch(picture, at, 0).a;
  float left = texelFetch(picture, ivec2(low.x, at.y), 0).a;
  float right = texelFetch(picture, ivec2(high.x, at.y), 0).a;
  float below = texelFetch(picture, ivec2(at.x, low.y), 0).a;
  float above = texelFetch(picture, ivec2(at.x, high.y), 0).a;
  float brightest = max(max(max(left, right), max(below, above)), here);
  float darkest = min(min(min(left, right), min(below, above)), here);
  if (brightest - darkest < max(least_contrast, 0.12 * brightest)) discard;

  bool level = abs(below + above - 2.0 * here) >= abs(left + right - 2.0 * here);
  float before = level ? below : left, after = level ? above : right;
  float side = abs(before - here) >= abs(after - here) ? -1.0 : 1.0;
  float beyond = side < 0.0 ? before : after;
  float border = 0.5 * (here + beyond), same = 0.25 * abs(here - beyond);
  vec2 across = side * (level ? vec2(0.0, 1.0) : vec2(1.0, 0.0));
  vec2 along = level ? vec2(1.0, 0.0) : vec2(0.0, 1.0);

  // Halfway between both rows, the sampler's average stays near `border` as long as the border continues.
  vec2 start = gl_FragCoord.xy + 0.5 * across;
  float reach_back = 0.0, reach_ahead = 0.0, end_back = 0.0, end_ahead = 0.0;
  for (int k = 0; k < most_steps; ++k) {
    float step = k < 3 ? 1.0 : 2.0;
    if (abs(end_back) < same) {
      reach_back += step;
      end_back = texture(picture, (start - reach_back * along) * pixel).a - border;
    }
    if (abs(end_ahead) < same) {
      reach_ahead += step;
      end_ahead = texture(picture, (start + reach_ahead * along) * pixel).a - border;
    }
    if (abs(end_back) >= same && abs(end_ahead) >= same) break;
  }
  float end = reach_back < reach_ahead ? end_back : end_ahead;
  bool crosses = (end < 0.0) != (here < border);
  float shift = crosses ? 0.5 - min(reach_back, reach_ahead) / (reach_back + reach_ahead) : 0.0;
  color = vec4(texture(picture, (gl_FragCoord.xy + shift * across) * pixel).rgb, 1.0);
}
