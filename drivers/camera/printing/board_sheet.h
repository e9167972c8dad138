#pragma once
// Prints a board on a sheet, true to scale, with a ruler to verify the scale.

#include <filesystem>
#include <optional>
#include <string>

#include "drivers/camera/tags/board.h"

namespace prosector {

/// Size of a sheet of paper in landscape orientation, m; A4 by default.
struct Paper {
  double width = 0.297, height = 0.210;
};
/// Returns the size of the paper named "a3", "a4" or "letter". Throws InputError for other names.
Paper paper_named(const std::string& name);

struct SheetSettings {
  Paper paper;
  double dots_per_inch = 300;  // resolution of PNG files
};

/// Writes a printable sheet with the board, true to scale, and a ruler to verify the scale. The file's
/// extension is .pdf, .svg or .png. Throws InputError if the board is not flat, is too large for the paper,
/// or the file cannot be written.
void write_sheet(const Board& board, const SheetSettings& settings, const std::filesystem::path& file);

}  // namespace prosector
