// Lays what ambient occlusion leaves of the light over the picture: the mean of 3 × 3 places that are as far away.

#include "ambient_occlusion.glsl"

uniform sampler2D openness;

out vec4 color;

void main() {
  vec2 size = vec2(textureSize(openness, 0));
  vec2 at = gl_FragCoord.xy / float(COARSER);
  if (texture(openness, at / size).r > 0.985) discard;
  // Half a place to each side: with the sampler's means, every one of the four directions counts as much.
  vec2 first = at - 0.5, last = at + 0.5;
  vec4 open = vec4(texture(openness, first / size).r, texture(openness, vec2(last.x, first.y) / size).r,
                   texture(openness, vec2(first.x, last.y) / size).r, texture(openness, last / size).r);
  ivec2 most = textureSize(scene_depth, 0) - 1;
  float nearness = nearness_at(ivec2(gl_FragCoord.xy));
  ivec2 a = clamp(COARSER * ivec2(first), ivec2(0), most), b = clamp(COARSER * ivec2(last), ivec2(0), most);
  vec4 other = vec4(nearness_at(a), nearness_at(ivec2(b.x, a.y)), nearness_at(ivec2(a.x, b.y)), nearness_at(b));
  vec4 weight = max(1.0 - abs(other / nearness - 1.0) / 0.02, 0.02);
  color = vec4(dot(open, weight) / dot(weight, vec4(1.0)));
}
