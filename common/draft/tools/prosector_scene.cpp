// prosector-scene: checks scene files, prints their manual, drafts new ones.

#include <CLI/CLI.hpp>

#include <fmt/format.h>

#include <cstdio>
#include <fstream>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/draft/draft_scene.h"
#include "common/error.h"
#include "common/file_endings.h"
#include "common/scene/load_scene.h"
#include "common/version.h"

namespace prosector {
namespace {

constexpr int bad_input = 2;  // exit status, as in the server

struct NewScene {
  std::filesystem::path source, out;
  std::string unit, up;
  DraftOptions options;
  bool force = false;
};

std::string atlases_text(const SceneDesc& scene) {
  if (scene.atlases.empty()) return "";
  return fmt::format(", {} label map{} whose structures become bodies", scene.atlases.size(),
                     scene.atlases.size() == 1 ? "" : "s");
}

/// Checks scene files. Returns the number of invalid ones.
int check(const std::vector<std::string>& files) {
  int bad = 0;
  for (const std::string& file : files) {
    try {
      const SceneDesc scene = load_scene(file);
      fmt::print("{}: {}: {} rigid, {} soft, {} lights{}\n", file, scene.name, scene.rigid.size(),
                 scene.soft.size(), scene.lights.size(), atlases_text(scene));
      for (const std::string& hint : scene_hints(scene)) fmt::print("{}: {}\n", file, hint);
    } catch (const InputError& e) {
      fmt::print(stderr, "{}\n", e.what());
      ++bad;
    }
  }
  return bad;
}

CLI::App* add_new(CLI::App& app, NewScene& o) {
  CLI::App* draft = app.add_subcommand("new", "Draft a scene from anatomy files");
  draft
      ->add_option("FILE|FOLDER", o.source,
                   "A closed surface (.obj .stl .ply .off .gltf .glb), a tetrahedral mesh (.msh .vtk), a "
                   "folder of them, "
                   "or a label map (.nii .nii.gz .inr .inr.gz)")
      ->required();
  draft->add_option("--out", o.out,
                    "Scene file to write (default: the source's name with .toml, in the current folder)");
  draft->add_option("--unit", o.unit, "Unit of surface files (default: guessed from the size and reported)")
      ->check(CLI::IsMember({"mm", "cm", "m"}));
  draft->add_option("--up", o.up, "Up axis of the files (default: y for surfaces, z for label maps)")
      ->check(CLI::IsMember({"y", "z"}));
  draft->add_flag("!--no-scalpel", o.options.scalpel, "Do not add a scalpel");
  draft->add_flag("--rigid", o.options.rigid, "Make rigid bodies of the surfaces, which may then be open");
  draft
      ->add_option("--labels", o.options.labels,
                   "Table of a label map's names and colours (default: the .csv or .txt file of the same "
                   "name in its folder)")
      ->check(CLI::ExistingFile);
  draft->add_flag("--force", o.force, "Overwrite an existing file");
  return draft;
}

std::filesystem::path default_out(const std::filesystem::path& source) {
  std::filesystem::path name = std::filesystem::weakly_canonical(source).filename();
  if (has_ending(name.native(), ".gz")) name.replace_extension();
  return name.replace_extension(".toml");
}

void write_new(NewScene o) {
  static const std::map<std::string, double> metres = {{"mm", 1e-3}, {"cm", 1e-2}, {"m", 1}};
  if (!o.unit.empty()) o.options.unit = metres.at(o.unit);
  if (!o.up.empty()) o.options.z_up = o.up == "z";
  if (o.out.empty()) o.out = default_out(o.source);
  if (!o.force && std::filesystem::exists(o.out))
    throw InputError(fmt::format("{} already exists; choose another --out, or use --force", o.out.string()));
  const auto folder = std::filesystem::absolute(o.out).parent_path();
  const Draft draft = draft_scene(o.source, folder, o.options);
  std::ofstream file(o.out, std::ios::binary);
  file << draft.toml;
  file.close();
  if (!file) throw std::runtime_error(fmt::format("{} cannot be written", o.out.string()));
  for (const std::string& note : draft.notes) fmt::print("{}\n", note);
  fmt::print("{}: written; host it with: prosector-server {}\n", o.out.string(), o.out.string());
}

int run(int argc, char** argv) {
  CLI::App app{"Check scene files, print their reference, or draft new ones.", "prosector-scene"};
  std::vector<std::string> files;
  bool manual = false;
  app.add_option("FILE", files, "Scene files (.toml) to check; referenced files are not opened");
  app.add_flag("--manual", manual, "Print the reference of scene files (docs/look-up/scene.md)");
  app.set_version_flag("--version", version_line("prosector-scene"));
  NewScene draft;
  const CLI::App* drafting = add_new(app, draft);
  try {
    app.parse(argc, argv);
    if (drafting->parsed()) return write_new(draft), 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : bad_input;
  } catch (const InputError& error) {
    fmt::print(stderr, "prosector-scene new: {}\n", error.what());
    return bad_input;
  } catch (const std::exception& error) {
    fmt::print(stderr, "prosector-scene new: {}\n", error.what());
    return 1;
  }
  if (files.empty() && !manual) {
    std::cerr
        << "prosector-scene: nothing to do: give a scene file, the command new, or --manual (see --help)\n";
    return bad_input;
  }
  if (manual) write_scene_manual(std::cout);
  return check(files) == 0 ? 0 : bad_input;
}

}  // namespace
}  // namespace prosector

int main(int argc, char** argv) {
  return prosector::run(argc, argv);
}
