#pragma once
// TOML text that is edited in place. All text outside the edit keeps every byte, comments and order included.
//
// The text must be valid TOML, which the caller checks first. Quoted keys with escapes are never found.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace prosector {

using TomlPath = std::vector<std::string>;
TomlPath split_toml_path(std::string_view dotted);

class TomlEditor {
 public:
  explicit TomlEditor(std::string text);

  const std::string& text() const { return text_; }
  /// Returns the text of the value at a dotted key of the TOML text, or nothing if the key is missing.
  std::optional<std::string> value(const TomlPath& path) const;
  /// Returns whether the TOML text defines this table by a header, by a dotted key below it, or as an inline
  /// table.
  bool has_table(const TomlPath& path) const;
  /// Sets the value at a key of the TOML text; `value` is TOML. A missing key is added to its table. A
  /// missing table is added at the end of the text.
  void set(const TomlPath& path, const std::string& value);
  /// Renames a key of the TOML text: `name` replaces the last part of its dotted name, so that it stays in
  /// its table. A missing key changes nothing.
  void rename(const TomlPath& path, const std::string& name);

 private:
  struct Entry {
    TomlPath path;
    std::size_t key_begin, key_end;  // offsets of the last part of the key
    std::size_t value_begin, value_end;
    std::size_t section;  // index of its section
    bool is_inline;       // member of an inline table
    bool is_table;        // the value is an inline table
  };
  struct Section {
    TomlPath path;
    std::size_t end;  // offset for a new key: after the last key's line or the header's line
    bool has_keys = false;
  };

  void scan();
  std::size_t scan_header(std::size_t at);
  std::size_t scan_entry(std::size_t at, const TomlPath& prefix, bool is_inline);
  std::size_t scan_value(std::size_t at, const TomlPath& path, bool* is_table);
  std::size_t scan_key(std::size_t at, TomlPath& path, std::size_t* last) const;
  std::size_t skip_blank(std::size_t at) const;
  std::size_t line_end(std::size_t at) const;
  const Entry* find(const TomlPath& path) const;
  void replace(std::size_t begin, std::size_t end, const std::string& with);
  bool add_to_inline_table(const TomlPath& path, const std::string& value);
  bool add_to_section(const TomlPath& path, const std::string& value);
  std::optional<std::size_t> group_for(const TomlPath& table) const;
  void add_section(const TomlPath& path, const std::string& value);

  std::string text_, line_break_;
  std::vector<Entry> entries_;
  std::vector<Section> sections_;  // the first is the root table
};

}  // namespace prosector
