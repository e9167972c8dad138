// Controls and their text: a texture with a tint, without lighting.

uniform sampler2D picture;

in vec2 texture_place;
in vec4 tint;

out vec4 color;

void main() { color = tint * texture(picture, texture_place); }
