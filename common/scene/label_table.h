#pragma once
// Label tables: names of a label map's structures, or of a scene's bodies, in several languages.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/local_name.h"
#include "common/math.h"

namespace prosector {

/// One row of a label table: a structure of a label map or a body of a scene, with its names.
struct Label {
  int id = 0;  // number in the label map; 0: identified by name only
  std::string name;
  std::vector<LocalName> names;  // in other languages
  std::string term;              // entry of Terminologia Anatomica (1998); empty: none
  std::optional<Vec3> color;     // linear red, green, blue
};

struct LabelTable {
  std::string file;  // for error messages
  std::vector<Label> labels;

  /// Returns the row of the label table with this number, or this name; null if there is none.
  const Label* find(int id) const;
  const Label* find(std::string_view name) const;
};

/// Parses a label table from text; `file` is used in messages. Two formats are accepted:
///   CSV whose first row names the columns: name, and optionally id, ta, color, name.LANGUAGE; colours are
///   #rrggbb (sRGB).
///   Lines of a number and a name, as supplied with atlases: "12 Frontal_Inf", optionally followed by a code,
///   or by red, green, blue (and alpha) in 0 … 255. Underscores become spaces.
/// Empty lines and lines that begin with # are skipped. Throws InputError with file, line and the allowed
/// values.
LabelTable parse_labels(std::string_view text, const std::string& file);

/// Reads a label table (names of structures or bodies) from a file of at most 4 MiB.
LabelTable load_labels(const std::filesystem::path& file);

}  // namespace prosector
