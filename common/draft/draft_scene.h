#pragma once
// Draft scene made from anatomy files: the output of `prosector-scene new`.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace prosector {

struct DraftOptions {
  std::optional<double> unit = {};  // m: unit of surface files; nullopt: guessed from their size
  std::optional<bool> z_up = {};  // the files' frame has z up; nullopt: true for volumes, false for surfaces
  bool rigid = false;             // all surfaces become rigid bodies, which may be open
  bool scalpel = true;            // add a scalpel next to the bodies that can be cut
  std::filesystem::path labels = {};  // of a label map; empty: searched next to it
};

struct Draft {
  std::string toml;
  std::vector<std::string> notes;  // messages for users: assumptions made, and how to change them
};

/// Creates the text of a draft scene from `source`: a surface, a tetrahedral mesh, a folder of both, or a
/// label map. The scene has bodies with material by file name and cell size by body size, a table, a scalpel
/// next to bodies that can be cut, a camera and lights. Paths in the scene are relative to `folder`, where it
/// will be written. Throws InputError for
///   a source that is none of these, or has no surface or tetrahedral mesh,
///   surfaces that aren't closed, unless they may be open; all such files of a folder are named,
///   two files with the same name, and
///   sizes for which no unit gives a body of 1 mm to 10 m.
Draft draft_scene(const std::filesystem::path& source, const std::filesystem::path& folder,
                  const DraftOptions& options);

/// Guesses the unit (m) of geometry files from the usual sizes (m) of the anatomical parts in them and the
/// extents in file units. Returns the one of mm, cm and m that fits best.
double guess_unit(const std::vector<double>& usual_sizes, const std::vector<double>& extents);

}  // namespace prosector
