#pragma once
// Printed objects to track: rigid arrangements of tags of the family 36h11 (Olson 2011; Wang and Olson 2016),
// flat or around a body; or any printed image.
//
// A board's frame has its origin at the centre of the grid or image. As seen by a viewer, x is right, y up, z
// towards the viewer; m.

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "common/image.h"
#include "common/math.h"

namespace prosector {

inline constexpr int tag_codes = 587;  // number of codes in the family, from 0
inline constexpr int tag_cells = 10;   // cells per side of a printed tag, white rim included
inline constexpr int black_cells = 8;  // cells per side of the black square, whose side is the tag's size

struct BoardTag {
  int code = 0;
  double size = 0;  // m, side of the black square
  Pose pose;        // pose of the tag's frame (x right, y up, z towards the viewer) in the board's frame

  /// Returns the corners of this tag's black square in the board's frame, m: lower left, lower right, upper
  /// right, upper left.
  std::array<Vec3, 4> corners() const;
};

/// A printed image that serves as a board and is recognised by its features. It lies in the board's plane z =
/// 0, centred at the origin.
struct PrintedImage {
  Image image;
  double width = 0;  // m

  double height() const { return width * image.height / image.width; }
};

struct Board {
  std::string name;
  std::vector<BoardTag> tags;                             // each code at most once
  std::shared_ptr<const PrintedImage> picture = nullptr;  // instead of tags; null: the board has tags

  const BoardTag* find(int code) const;
  /// Reports whether all tags of the board lie in the board's plane z = 0.
  bool is_flat() const;
};

/// Description of a board with a grid of tags: rows from the top, tags in a row from the left. The tags'
/// codes count up from `first`.
struct TagGrid {
  int columns = 4, rows = 3;
  double size = 0.03, gap = 0.008;  // m; the gap is between black squares
  int first = 0;
};
Board grid_board(const std::string& name, const TagGrid& grid);

/// Reads a board's TOML file. It contains a [grid], a list of [[tag]] with code, size, position and
/// orientation, or a [picture] with file and width. Throws InputError with file, line, key and the allowed
/// values.
Board load_board(const std::filesystem::path& file);

/// Returns the printed cells of the tag with this code, rows from the top; true is black. The cells of the
/// outer rim are white.
std::array<std::array<bool, tag_cells>, tag_cells> tag_ink(int code);

}  // namespace prosector
