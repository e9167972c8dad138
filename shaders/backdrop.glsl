// Lookup of the camera image at the window's pixel.

uniform sampler2D picture;
uniform vec4 place;  // pixels of the image: position of the window's lower left corner; step per pixel of the window

vec2 place_in_picture() {
  return (place.xy + place.zw * gl_FragCoord.xy) / vec2(textureSize(picture, 0));
}
