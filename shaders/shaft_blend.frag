// Adds the light shaft, which was rendered at lower resolution, to the frame.

uniform sampler2D air;
uniform vec4 texel_from_pixel[1];  // scale, offset

out vec4 color;

void main() {
  vec2 at = gl_FragCoord.xy * texel_from_pixel[0].xy + texel_from_pixel[0].zw;
  vec3 light = texture(air, at).rgb;
  if (light.r + light.g + light.b <= 0.0) discard;
  color = vec4(light, 0.0);
}
