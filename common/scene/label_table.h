#pragma once
// Tables of names: of a label map's structures, or of a scene's bodies, in several languages.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/local_name.h"
#include "common/math.h"

namespace prosector {

/// One row: a structure or body, and what it is called.
struct Label {
  int id = 0;  // of a label map; 0: known by its name alone
  std::string name;
  std::vector<LocalName> names;  // in other languages
  std::string term;              // entry of Terminologia Anatomica (1998); empty: none
  std::optional<Vec3> color;     // linear red, green, blue
};

struct LabelTable {
  std::string file;  // for messages
  std::vector<Label> labels;

  /// Returns the row of this number, or name; null: there is none.
  const Label* find(int id) const;
  const Label* find(std::string_view name) const;
};

/// Reads a table from text; `file` is for messages. Two forms are read:
///   CSV whose first row names the columns: name, and any of id, ta, color, name.LANGUAGE. Colours are
///   #rrggbb (sRGB).
///   lines of a number and a name, as atlases come with: "12 Frontal_Inf", then a code, or red, green, blue
///   (and alpha) in 0 … 255. Underscores become blanks.
/// Empty lines, and lines that begin with #, are skipped. Throws InputError with file, line and what is
/// allowed.
LabelTable parse_labels(std::string_view text, const std::string& file);

/// Reads a table from a file of at most 4 MiB.
LabelTable load_labels(const std::filesystem::path& file);

}  // namespace prosector
