// prosector-board: boards of tags to print.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "common/error.h"
#include "common/version.h"
#include "drivers/camera/printing/board_sheet.h"
#include "drivers/camera/tags/known_boards.h"

namespace prosector {
namespace {

void list() {
  for (const KnownBoard& row : known_boards())
    fmt::print("{:12} {} × {} tags of {:.1f} mm, codes from {}: {}\n", row.name, row.grid.columns,
               row.grid.rows, 1e3 * row.grid.size, row.grid.first, row.help);
}

int run(int argc, char** argv) {
  CLI::App app("Makes sheets of tags to print, which cameras track.");
  app.set_version_flag("--version", version_line("prosector-board"));
  std::string board, file, paper = "a4";
  SheetSettings settings;
  bool lists = false;
  app.add_option("board", board, "a known board, or a file of one (board.toml)");
  app.add_option("--out", file, "file to write: .pdf, .svg or .png");
  app.add_option("--paper", paper, "a3, a4 or letter")->capture_default_str();
  app.add_option("--dots", settings.dots_per_inch, "of a PNG's inch")
      ->check(CLI::Range(50, 2400))
      ->capture_default_str();
  app.add_flag("--list", lists, "say which boards are known");
  CLI11_PARSE(app, argc, argv);
  try {
    if (lists) {
      list();
      return 0;
    }
    if (board.empty() || file.empty()) throw InputError("name a board and --out FILE, or ask for --list");
    settings.paper = paper_named(paper);
    write_sheet(find_board(board), settings, file);
    fmt::print("{}: print it at 100 %, and measure the ruler: it must be 100 mm\n", file);
    return 0;
  } catch (const InputError& error) {
    fmt::print(stderr, "prosector-board: {}\n", error.what());
    return 2;
  }
}

}  // namespace
}  // namespace prosector

int main(int argc, char** argv) {
  return prosector::run(argc, argv);
}
