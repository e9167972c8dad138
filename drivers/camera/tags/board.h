#pragma once
// What is printed and tracked: tags of the family 36h11 (Olson 2011; Wang and Olson 2016) that are fixed to
// each other, flat or around a body; or any picture.
//
// A board's frame: the middle of a grid or picture is the origin; x right, y up as one looks at it, z towards
// who looks; m.

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "common/image.h"
#include "common/math.h"

namespace prosector {

inline constexpr int tag_codes = 587;  // of the family, from 0
inline constexpr int tag_cells =
    10;  // of a printed tag's side, the white rim around its black border included
inline constexpr int black_cells = 8;  // of the side that is meant by a tag's size

struct BoardTag {
  int code = 0;
  double size = 0;  // m, side of the black square
  Pose pose;        // of the tag's frame (x right, y up, z towards who looks) in the board's

  /// Returns the black square's corners in the board's frame: lower left, lower right, upper right, upper
  /// left.
  std::array<Vec3, 4> corners() const;
};

/// A page that is known by what is printed on it. It fills the plane z = 0 around the origin.
struct PrintedPicture {
  Image image;
  double width = 0;  // m

  double height() const { return width * image.height / image.width; }
};

struct Board {
  std::string name;
  std::vector<BoardTag> tags;                               // each code once
  std::shared_ptr<const PrintedPicture> picture = nullptr;  // in the place of tags; null: it has tags

  const BoardTag* find(int code) const;
  /// Tells whether all tags lie in the plane z = 0.
  bool is_flat() const;
};

/// Rows from the top, each from the left; codes count up from `first`.
struct TagGrid {
  int columns = 4, rows = 3;
  double size = 0.03, gap = 0.008;  // m; the gap is between black squares
  int first = 0;
};
Board grid_board(const std::string& name, const TagGrid& grid);

/// Reads a board's file: a [grid], a list of [[tag]] with code, size, position and orientation, or a
/// [picture] with file and width. Throws InputError with file, line, key and what is allowed.
Board load_board(const std::filesystem::path& file);

/// Returns the ink of a code, rows from the top: true is black. Its rim is white.
std::array<std::array<bool, tag_cells>, tag_cells> tag_ink(int code);

}  // namespace prosector
