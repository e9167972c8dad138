#pragma once
// Which fonts there are, and which characters each has.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

struct _FcCharSet;

namespace prosector {

struct FontFile {
  std::filesystem::path path;
  int index = 0;  // of the face in the file, as FreeType counts
  std::string family;
};

/// Fonts in the order in which they are asked for a character. No two systems have the same ones, so those
/// that Prosector recommends come first: with them installed, text looks alike everywhere.
class FontCatalogue {
 public:
  /// Lists the outline fonts of this system that add characters to those before them (fontconfig). Throws
  /// InputError, naming the Debian package, when there is none.
  FontCatalogue();
  /// Lists these files, as they are ordered. Throws InputError for a file that is no font, and for no files.
  explicit FontCatalogue(const std::vector<std::filesystem::path>& files);

  std::size_t size() const { return entries_.size(); }
  const FontFile& file(std::size_t font) const { return entries_.at(font).file; }
  bool has(std::size_t font, char32_t character) const;

 private:
  struct Entry {
    FontFile file;
    std::shared_ptr<const _FcCharSet> characters;
  };
  std::vector<Entry> entries_;
};

}  // namespace prosector
