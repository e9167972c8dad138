#pragma once
// One description of every key that a scene may hold: where it is stored, its unit, range and meaning. The
// loader, its error messages and docs/look-up/scene.md all come from here. Defaults are not repeated: they
// are read from a default-constructed description.

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "common/scene/scene.h"

namespace prosector {

/// Where a key's value is stored. An enumeration's numbers are its words' places in Field::words.
using FieldRef = std::variant<double*, int*, bool*, std::string*, Vec3*, Quat*, LightKind*, Surface*,
                              Quantity*, std::vector<std::string>*, std::vector<double>*, std::vector<Vec3>*>;

/// Bounds of a number, of a quantity in its unit, or of each component of a vector.
struct Range {
  double min = 0;
  double max = 0;
  bool open_min = false;  // true: min itself is out
  bool open_max = false;

  bool contains(double x) const {  // false for NaN
    return (open_min ? x > min : x >= min) && (open_max ? x < max : x <= max);
  }
};

/// What a string without a list of words may hold.
enum class Text {
  free,        // anything
  name,        // not empty, no control characters
  identifier,  // a-z, 0-9, _, starting with a letter
};

/// How the hash of a compiled scene depends on a key. Recordings and checkpoints fit scenes of equal hash.
enum class Hashed {
  by_value,    // by its value: the simulation reads it
  compiled,    // by what is compiled from it: meshes, poses, masses
  not_hashed,  // not at all: it affects texts, appearance, admission, or which rung the server chooses
};

struct Field {
  std::string_view key;
  FieldRef (*in)(void* object);  // the field of the table's struct that starts at `object`
  Hashed hashed;
  std::string_view unit = "";
  Range range = {};                          // double, int, Vec3, lists of them
  std::vector<std::string_view> words = {};  // string, enumeration; empty: any that `text` admits
  Text text = Text::free;
  std::size_t max_length = max_name_length;  // string: bytes; list of numbers or of points: entries
  bool required = false;
  std::string_view description;
};

struct Table;

/// The structs of a table inside another; `object` is a struct of the outer table.
struct Items {
  void* (*add)(void* object);  // the struct to fill; repeated: a new one at the end of the list
  std::vector<void*> (*present)(void* object);  // those that there are, in order
};

/// A table inside another: [key], or [[key]] when it may occur several times.
struct Child {
  std::string_view key;
  const Table& (*table)();
  bool repeated;
  std::size_t max_count;  // repeated: how many at most
  Items items;
};

struct Table {
  std::string_view name;  // as a scene file writes it: "[session]", "[[rigid.part]]"; "": the top level
  std::string_view description;
  std::vector<Field> fields;
  std::vector<Child> children;
  std::shared_ptr<void> (*fresh)();  // a default-constructed struct: what a key not given holds
};

/// Returns the top level; every other table is a child or a grandchild of it.
const Table& scene_table();

/// Returns what a message or the manual says is allowed: "in (0, 1e12]", "one of: a, b" …; `value` tells the
/// type.
std::string allowed(const Field& field, const FieldRef& value);

}  // namespace prosector
