#pragma once
// A board as a sheet to print, true to scale, with a ruler to check that by.

#include <filesystem>
#include <optional>
#include <string>

#include "drivers/camera/tags/board.h"

namespace prosector {

/// A paper, m, lying on its long side.
struct Paper {
  double width = 0.297, height = 0.210;
};
/// Returns the paper of that name: a3, a4 or letter. Throws InputError for others.
Paper paper_named(const std::string& name);

struct SheetSettings {
  Paper paper;
  double dots_per_inch = 300;  // of PNG
};

/// Writes the sheet as .pdf, .svg or .png. Throws InputError where the board isn't flat or is too large for
/// the paper, or the file can't be written.
void write_sheet(const Board& board, const SheetSettings& settings, const std::filesystem::path& file);

}  // namespace prosector
