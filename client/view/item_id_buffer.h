#pragma once
// Item-id buffer: which item is visible where in a view, at low resolution, without any GL.

#include <cstdint>
#include <vector>

#include "client/view/draw_list.h"

namespace prosector {

/// Low-resolution image of a view that holds for each cell the visible item instead of a colour; rows from
/// the top. Half-transparent and glass items hide nothing and are not included.
struct ItemIdBuffer {
  struct Cell {
    float nearness = 0;          // 1/m: reciprocal of the depth along the view axis; 0: empty
    std::int32_t item = -1;      // index in the list; −1: empty
    std::uint32_t triangle = 0;  // index in triangles_of(item)
  };
  int width = 0, height = 0;
  std::vector<Cell> cells;

  const Cell& at(int x, int y) const {
    return cells[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
  }
};

inline constexpr double solid_opacity = 0.5;  // minimum opacity of an item that hides what is behind it

/// Renders which of the list's items the camera sees where, as a buffer of `width` × `height` cells.
ItemIdBuffer rasterize_items(const DrawList& list, const DrawCamera& camera, int width, int height);

}  // namespace prosector
