#include "whole_picture.glsl"
