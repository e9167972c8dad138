// prosector-scene: checks scene files; prints their manual.

#include <CLI/CLI.hpp>

#include <fmt/format.h>

#include <cstdio>
#include <iostream>
#include <string>
#include <vector>

#include "common/error.h"
#include "common/scene/load_scene.h"

int main(int argc, char** argv) {
  CLI::App app{"Check scene files, or print what they may hold.", "prosector-scene"};
  std::vector<std::string> files;
  bool manual = false;
  app.add_option("FILE", files, "Scene files (.toml) to check; nothing that they name is opened");
  app.add_flag("--manual", manual, "Print the manual of scene files (docs/scene.md)");
  CLI11_PARSE(app, argc, argv);
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
    } catch (const prosector::InputError& e) {
      fmt::print(stderr, "{}\n", e.what());
      ++bad;
    }
  }
  return bad == 0 ? 0 : 1;
}
