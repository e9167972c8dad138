// What both shaders of ambient occlusion read of the picture's depth.

uniform sampler2D scene_depth;
uniform vec4 lens[1];      // 1/near, 1/far (1/m), pixels of a metre at a metre, radius of the ball (m)
uniform vec4 viewport[1];  // x, y, width, height, in pixels

// One over the distance ahead of the eye, 1/m: along any plane, linear over the picture.
float nearness_at(ivec2 pixel) { return mix(lens[0].x, lens[0].y, texelFetch(scene_depth, pixel, 0).r); }
