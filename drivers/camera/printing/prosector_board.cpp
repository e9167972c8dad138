// prosector-board: prints boards of tags.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "common/error.h"
#include "common/former_option_name.h"
#include "common/version.h"
#include "drivers/camera/printing/board_sheet.h"
#include "drivers/camera/tags/standard_boards.h"

namespace prosector {
namespace {

void list() {
  for (const StandardBoard& row : standard_boards())
    fmt::print("{:12} {} × {} tags of {:.1f} mm, first code {}: {}\n", row.name, row.grid.columns,
               row.grid.rows, 1e3 * row.grid.size, row.grid.first, row.help);
}

int run(int argc, char** argv) {
  CLI::App app("Creates printable sheets of tags for camera tracking.");
  app.set_version_flag("--version", version_line("prosector-board"));
  std::string board, file, paper = "a4";
  SheetSettings settings;
  bool lists = false;
  app.add_option("board", board, "board to print: name of a known board (see --list), or board file (.toml)");
  app.add_option("--out", file, "file to write: .pdf, .svg or .png");
  app.add_option("--paper", paper, "a3, a4 or letter")->capture_default_str();
  CLI::Option* dpi = app.add_option("--dpi", settings.dots_per_inch, "resolution of a PNG, dots per inch");
  dpi->check(CLI::Range(50, 2400))->capture_default_str();
  accept_former_name(app, *dpi, "--dots");
  app.add_flag("--list", lists, "list the known boards");
  CLI11_PARSE(app, argc, argv);
  try {
    if (lists) {
      list();
      return 0;
    }
    if (board.empty() || file.empty())
      throw InputError("give the board to print and --out FILE, or --list to list the known boards");
    settings.paper = paper_named(paper);
    write_sheet(find_board(board), settings, file);
    fmt::print("{}: print it at 100 %; the printed ruler must measure 100 mm\n", file);
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
