#pragma once
// Field tables: one description of each scene key with its storage, unit, range and meaning. The loader, its
// error messages and docs/look-up/scene.md use them. Defaults are not repeated here: they are read from a
// default-constructed description.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "common/ids.h"
#include "common/scene/scene.h"

namespace prosector {

/// Pointer to the variable in which a scene key's value is stored. An enumeration is stored in one byte
/// (std::uint8_t*): the index of its word in Field::words.
using FieldRef = std::variant<double*, int*, bool*, std::string*, Vec3*, Quat*, std::uint8_t*, Quantity*,
                              std::vector<std::string>*, std::vector<double>*, std::vector<Vec3>*>;

/// Allowed range of a scene key's number, of a quantity in its unit, or of each component of a vector.
struct Range {
  double min = 0;
  double max = 0;
  bool open_min = false;  // true: min itself is excluded
  bool open_max = false;

  bool contains(double x) const {  // false for NaN
    return (open_min ? x > min : x >= min) && (open_max ? x < max : x <= max);
  }
};

/// Kind of text that a scene key's string may contain, if it has no list of allowed words.
enum class Text {
  free,        // anything
  name,        // not empty, no control characters
  identifier,  // a-z, 0-9, _, starting with a letter
};

/// Way in which a scene key affects the hash of the compiled scene. Recordings and checkpoints can only be
/// used with a scene of equal hash.
enum class Hashed {
  by_value,    // by its value: the simulation reads it
  compiled,    // by the data compiled from it: meshes, poses, masses
  not_hashed,  // not at all: texts, appearance, admission, or the server's choice of model configuration
};

struct Field {
  std::string_view key;
  FieldRef (*in)(void* object);  // returns a pointer to the field in the table's struct at `object`
  Hashed hashed;
  std::string_view unit = "";
  Range range = {};                          // double, int, Vec3, lists of them
  std::vector<std::string_view> words = {};  // string, enumeration; empty: any string that `text` allows
  Text text = Text::free;
  std::size_t max_length = max_name_length;  // string: bytes; list of numbers or of points: entries
  bool required = false;
  std::string_view description;
};

struct Table;

/// Access to the structs that store a nested table of a scene file. `object` is a struct of the outer table.
struct Items {
  void* (*add)(void* object);  // returns the struct to fill; repeated: a new one appended to the list
  std::vector<void*> (*present)(void* object);  // returns the existing structs, in order
};

/// A table nested in another table of a scene file: [key], or [[key]] if it may occur several times.
struct Child {
  std::string_view key;
  const Table& (*table)();
  bool repeated;
  std::size_t max_count;  // repeated: maximum number
  Items items;
};

struct Table {
  std::string_view name;  // as written in a scene file: "[session]", "[[rigid.part]]"; "": the top level
  std::string_view description;
  std::vector<Field> fields;
  std::vector<Child> children;
  std::shared_ptr<void> (*fresh)();  // returns a default-constructed struct, from which defaults are read
};

/// Returns the field table of a scene file's top level; all other tables are its descendants.
const Table& scene_table();

/// Returns the allowed values of a scene key as text for messages and the manual, such as "in (0, 1e12]" or
/// "one of: a, b". `value` gives the type of the key.
std::string allowed(const Field& field, const FieldRef& value);

}  // namespace prosector
