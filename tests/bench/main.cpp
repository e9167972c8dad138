// prosector-bench: what things cost on this machine.

#include <CLI/CLI.hpp>
#include <fstream>
#include <iostream>

#include "tests/bench/machine.h"
#include "tests/bench/subjects.h"

int main(int argc, char** argv) try {
  CLI::App app("Measures what things cost on this machine.", "prosector-bench");
  app.require_subcommand(1);
  std::string file;
  app.add_option("--json", file, "Also write the figures to this file");
  app.fallthrough();

  prosector::SoftBenchOptions soft;
  CLI::App* soft_command = app.add_subcommand("soft", "A Newton iteration of one soft body, for every law");
  soft_command->add_option("--tets", soft.tets, "Size, about")->check(CLI::Range(6, 10000000));
  soft_command->add_option("--threads", soft.threads, "Threads")->check(CLI::Range(1, 1024));
  soft_command->add_option("--repeats", soft.repeats, "Calls of which the median is told")
      ->check(CLI::Range(1, 1000000));
  CLI11_PARSE(app, argc, argv);

  nlohmann::json report = {{"machine", prosector::machine()}};
  std::cout << report["machine"].dump() << std::endl;
  if (*soft_command) report["soft"] = prosector::bench_soft(soft);
  if (!file.empty() && !(std::ofstream(file) << report.dump(2) << "\n")) {
    std::cerr << "prosector-bench: cannot write " << file << "\n";
    return 1;
  }
  return 0;
} catch (const std::exception& error) {
  std::cerr << "prosector-bench: " << error.what() << "\n";
  return 1;
}
