#include "common/scene/field_values.h"

#include <string>
#include <vector>

#include "common/scene/scene_fields.h"

namespace prosector {
namespace {

template <class T>
void add(ByteWriter& out, const T& value) {
  out.add(value);
}
void add(ByteWriter& out, const Quantity& value) {
  out.add(value.value);
}
template <class T>
void add(ByteWriter& out, const std::vector<T>& list) {
  out.add(static_cast<std::uint64_t>(list.size()));
  for (const T& value : list) out.add(value);
}

/// Returns a field's value as bytes. A list is preceded by its length. An enumeration is written as its word.
std::vector<std::uint8_t> bytes_of(const Field& field, const FieldRef& ref) {
  ByteWriter out;
  if (std::uint8_t* const* word = std::get_if<std::uint8_t*>(&ref))
    out.add(std::string(field.words.at(**word)));
  else
    std::visit([&](const auto* value) { add(out, *value); }, ref);
  return out.take();
}

void add_table(const Table& table, void* object, ByteWriter& out) {
  const std::shared_ptr<void> defaults = table.fresh();
  for (const Field& field : table.fields) {
    if (field.hashed != Hashed::by_value) continue;
    const auto value = bytes_of(field, field.in(object));
    if (value == bytes_of(field, field.in(defaults.get()))) continue;
    out.add(std::string(field.key));
    out.raw(value.data(), value.size());
  }
  for (const Child& child : table.children)
    for (void* item : child.items.present(object)) {
      out.add(std::string(child.key));
      add_table(child.table(), item, out);
    }
  out.add(std::string());  // marks the end of the table: no key is empty
}

}  // namespace

void add_values(const SceneDesc& scene, ByteWriter& out) {
  SceneDesc copy = scene;  // the tables return non-const pointers
  add_table(scene_table(), &copy, out);
}

}  // namespace prosector
