#pragma once
// Rows of a list of parts: the scene's parts in groups, their look for one viewer, and their holders.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "client/language/catalogue.h"
#include "client/replica/replica.h"
#include "client/view/parts_choice.h"

namespace prosector {

struct PartHolder {
  std::string name;
  Vec3 color;  // linear red, green, blue
  bool operator==(const PartHolder&) const = default;
};

/// Data from which the list of parts is built: the scene, the organ of each body, and the participants that
/// hold each body.
struct PartsData {
  SceneInfo scene;
  std::vector<BodyId> organs;                    // the body that each body was cut from (organs_of())
  std::vector<std::vector<PartHolder>> holders;  // by body
};
PartsData parts_data(const Replica& replica);

/// Returns, by body id, how the viewer sees each body. A piece that was cut off looks like the organ that it
/// came from.
std::vector<PartLook> looks_of(const Replica& replica, const PartsChoice& choice);

struct PartRow {
  bool is_head = false;                 // a group's heading
  std::string text = {};                // in the viewer's language
  std::vector<std::string> parts = {};  // names in the scene file: one; of a heading, those of all its rows
  std::vector<BodyId> bodies = {};      // the part and its pieces; of a heading none
  std::vector<PartHolder> holders = {};
  PartLook look = {};         // effective look; of a heading: hidden if all are, the least opacity
  Vec3 color = Vec3::Zero();  // current colour, linear
  bool isolated = false;      // of a heading: all are
};

/// Returns the rows of the list of parts that match the search text by name in any language, or by id of
/// Terminologia Anatomica. Case and accents are ignored (search_key()). Groups without matching rows are
/// omitted.
std::vector<PartRow> part_rows(const PartsData& known, const PartsChoice& choice, std::string_view search,
                               const Catalogue& words = {});

/// Returns the scene-file names of the parts that a user means by `name`. This is the part with exactly that
/// name in any language, otherwise all parts that match it as a search text.
std::vector<std::string> parts_called(const PartsData& known, std::string_view name);

/// Returns the rows of a list of parts as lines of text for a terminal.
std::string rows_as_text(const std::vector<PartRow>& rows);

}  // namespace prosector
