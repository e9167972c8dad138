// A camera's picture at the window's pixel.

uniform sampler2D picture;
uniform vec4 place;  // of the picture: at the window's lower left corner, and what a pixel of the window goes on

vec2 place_in_picture() {
  return (place.xy + place.zw * gl_FragCoord.xy) / vec2(textureSize(picture, 0));
}
