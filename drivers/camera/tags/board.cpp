#include "drivers/camera/tags/board.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "drivers/camera/base/image_reader.h"
#include "drivers/files/toml_fields.h"

namespace prosector {
namespace {

constexpr double least_size = 0.002, most_size = 2;  // m
constexpr int most_side = 40;                        // most tags per side of a grid
constexpr double least_width = 0.02;                 // m, of a printed image

TagGrid read_grid(const TomlFields& fields) {
  TagGrid grid;
  grid.columns = fields.whole("columns", 1, most_side);
  grid.rows = fields.whole("rows", 1, most_side);
  grid.size = fields.number("size", least_size, most_size);
  // Rims of neighbours may touch: one cell each.
  const double least_gap = grid.rows * grid.columns > 1 ? 2 * grid.size / black_cells : 0;
  grid.gap = fields.number("gap", least_gap, most_size, least_gap);
  grid.first = fields.whole("first", 0, tag_codes - grid.columns * grid.rows);
  fields.reject_unknown_keys();
  return grid;
}

BoardTag read_tag(const TomlFields& fields) {
  BoardTag tag;
  tag.code = fields.whole("code", 0, tag_codes - 1);
  tag.size = fields.number("size", least_size, most_size);
  tag.pose = fields.pose();
  fields.reject_unknown_keys();
  return tag;
}

PrintedImage read_printed(const TomlFields& fields) {
  PrintedImage out{read_image(fields.file("file")), fields.number("width", least_width, most_size)};
  fields.reject_unknown_keys();
  return out;
}

}  // namespace

std::array<Vec3, 4> BoardTag::corners() const {
  const double h = size / 2;
  return {pose * Vec3(-h, -h, 0), pose * Vec3(h, -h, 0), pose * Vec3(h, h, 0), pose * Vec3(-h, h, 0)};
}

const BoardTag* Board::find(int code) const {
  const auto at = std::find_if(tags.begin(), tags.end(), [&](const BoardTag& t) { return t.code == code; });
  return at == tags.end() ? nullptr : &*at;
}

bool Board::is_flat() const {
  return std::all_of(tags.begin(), tags.end(), [](const BoardTag& tag) {
    const auto corners = tag.corners();
    return std::all_of(corners.begin(), corners.end(), [](const Vec3& c) { return std::abs(c.z()) < 1e-6; });
  });
}

Board grid_board(const std::string& name, const TagGrid& grid) {
  Board board{name, {}};
  const double pitch = grid.size + grid.gap;
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      BoardTag tag{grid.first + row * grid.columns + column, grid.size, {}};
      tag.pose.p = {(column - 0.5 * (grid.columns - 1)) * pitch, (0.5 * (grid.rows - 1) - row) * pitch, 0};
      board.tags.push_back(tag);
    }
  return board;
}

Board load_board(const std::filesystem::path& file) {
  const TomlFields fields = TomlFields::load(file, "board");
  Board board{fields.text("name", file.stem().string()), {}};
  const auto add = [&](const TomlFields& from, const char* key, const BoardTag& tag) {
    if (board.find(tag.code) != nullptr)
      from.fail(key,
                fmt::format("tag code {} is on this board already: each tag needs another code", tag.code));
    board.tags.push_back(tag);
  };
  for (const TomlFields& grid : fields.tables("grid"))
    for (const BoardTag& tag : grid_board("", read_grid(grid)).tags) add(grid, "first", tag);
  for (const TomlFields& one : fields.tables("tag")) add(one, "code", read_tag(one));
  for (const TomlFields& one : fields.tables("picture")) {
    if (!board.tags.empty() || board.picture)
      fields.fail("picture", "a board has tags or one picture, not both");
    board.picture = std::make_shared<const PrintedImage>(read_printed(one));
  }
  fields.reject_unknown_keys();
  if (board.tags.empty() && !board.picture)
    fields.fail("grid", "is missing: a board needs [[grid]], [[tag]] or [picture]");
  return board;
}

}  // namespace prosector
