#pragma once
// The lines of a list of parts: what a scene has, in groups, as a viewer sees it, and who holds it.

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

/// What a list of parts is made of.
struct PartsKnown {
  SceneInfo scene;
  std::vector<BodyId> organs;                    // what each body was cut off (organs_of())
  std::vector<std::vector<PartHolder>> holders;  // of each body
};
PartsKnown parts_known(const Replica& replica);

/// Returns how each body is seen; pieces as what they were cut off.
std::vector<PartLook> looks_of(const Replica& replica, const PartsChoice& choice);

struct PartRow {
  bool is_head = false;                 // of a group
  std::string text = {};                // in the viewer's language
  std::vector<std::string> parts = {};  // the author's names: one; of a head, of all rows below it
  std::vector<BodyId> bodies = {};      // the part and its pieces; of a head none
  std::vector<PartHolder> holders = {};
  PartLook look = {};         // as it is seen; of a head, hidden: all are; opacity: the least
  Vec3 color = Vec3::Zero();  // that it has now, linear
  bool isolated = false;      // of a head: all are
};

/// Returns the rows that the search finds: by name in any language, and by id of Terminologia Anatomica.
/// Letters match as search_key() says. Groups without rows are left out.
std::vector<PartRow> part_rows(const PartsKnown& known, const PartsChoice& choice, std::string_view search,
                               const Catalogue& words = {});

/// Returns the author's names of parts that `name` means: the one that is called so, or else all that the
/// search finds.
std::vector<std::string> parts_called(const PartsKnown& known, std::string_view name);

/// Returns rows as lines for a terminal.
std::string told_rows(const std::vector<PartRow>& rows);

}  // namespace prosector
