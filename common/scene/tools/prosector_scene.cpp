// prosector-scene: checks scene files; prints their manual.

#include <CLI/CLI.hpp>

#include <fmt/format.h>

#include <cstdio>
#include <iostream>
#include <string>
#include <vector>

#include "common/error.h"
#include "common/scene/hints.h"
#include "common/scene/load_scene.h"
#include "common/version.h"

int main(int argc, char** argv) {
  CLI::App app{"Check scene files, or print what they may hold.", "prosector-scene"};
  std::vector<std::string> files;
  bool manual = false;
  app.add_option("FILE", files, "Scene files (.toml) to check; nothing that they name is opened");
  app.add_flag("--manual", manual, "Print the manual of scene files (docs/look-up/scene.md)");
  app.set_version_flag("--version", prosector::version_line("prosector-scene"));
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  if (files.empty() && !manual) {
    std::cerr << "prosector-scene: name a scene file, or --manual (see --help)\n";
    return 2;
  }
  if (manual) prosector::write_scene_manual(std::cout);

  int bad = 0;
  for (const std::string& file : files) {
    try {
      const prosector::SceneDesc scene = prosector::load_scene(file);
      fmt::print("{}: {}: {} rigid, {} soft, {} lights\n", file, scene.name, scene.rigid.size(),
                 scene.soft.size(), scene.lights.size());
      for (const std::string& hint : prosector::scene_hints(scene)) fmt::print("{}: {}\n", file, hint);
    } catch (const prosector::InputError& e) {
      fmt::print(stderr, "{}\n", e.what());
      ++bad;
    }
  }
  return bad == 0 ? 0 : 1;
}
