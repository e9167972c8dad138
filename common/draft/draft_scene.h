#pragma once
// A scene's first draft, made from files of anatomy: what `prosector-scene new` writes.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace prosector {

struct DraftOptions {
  std::optional<double> unit = {};    // m: of surface files; none: guessed by size
  std::optional<bool> z_up = {};      // of the files' frame; none: volumes yes, surfaces no
  bool rigid = false;                 // every surface keeps its shape, and may be open
  bool scalpel = true;                // one lies beside what can be cut
  std::filesystem::path labels = {};  // of a label map; empty: looked for beside it
};

struct Draft {
  std::string toml;
  std::vector<std::string> notes;  // lines for people: what was assumed, and how to say otherwise
};

/// Makes a scene of what `source` holds: a surface, a tetrahedral mesh, all of these in a folder, or a label
/// map. The scene has the bodies by name and material, cells by their size, a table under them and a scalpel
/// beside what can be cut. A camera shows them all, in light. Paths in it are those from `folder`, where it
/// will be written. Throws InputError for
///   a source that is none of these, or holds no surface or tetrahedral mesh
///   surfaces that aren't closed, unless they may be open; every one of a folder is named
///   two files of one name
///   sizes that no unit makes a body of 1 mm to 10 m
Draft draft_scene(const std::filesystem::path& source, const std::filesystem::path& folder,
                  const DraftOptions& options);

/// Guesses the unit (m) of files in which parts of these usual sizes (m) have these extents: mm, cm or m,
/// whichever comes nearest.
double guessed_unit(const std::vector<double>& usual_sizes, const std::vector<double>& extents);

}  // namespace prosector
