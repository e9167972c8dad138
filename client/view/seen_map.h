#pragma once
// Which item of a list is seen where in a picture: a coarse picture of numbers, without any GL.

#include <cstdint>
#include <vector>

#include "client/view/draw_list.h"

namespace prosector {

/// Cells of a picture, rows from the top. What is half transparent or glass hides nothing and isn't there.
struct SeenMap {
  struct Cell {
    float nearness = 0;          // 1/m: of what is seen, one over its depth along the view; 0: nothing
    std::int32_t item = -1;      // of the list; −1: nothing
    std::uint32_t triangle = 0;  // of triangles_of(item)
  };
  int width = 0, height = 0;
  std::vector<Cell> cells;

  const Cell& at(int x, int y) const {
    return cells[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
  }
};

inline constexpr double solid_opacity = 0.5;  // from there on an item hides what is behind it

/// Draws the list's items as the camera sees them, in so many cells.
SeenMap map_seen(const DrawList& list, const DrawCamera& camera, int width, int height);

}  // namespace prosector
