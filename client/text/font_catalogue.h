#pragma once
// Available fonts and their character sets.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

struct _FcCharSet;

namespace prosector {

struct FontFile {
  std::filesystem::path path;
  int index = 0;  // FreeType's index of the face in the file
  std::string family;
};

/// Fonts in order of preference, with the set of characters of each. Systems have different fonts, so the
/// ones recommended for Prosector are first: with them installed, text looks the same everywhere.
class FontCatalogue {
 public:
  /// Lists this system's outline fonts, found by fontconfig. A font is listed only if it adds characters to
  /// the fonts before it. Throws InputError with the name of the Debian package to install if there are none.
  FontCatalogue();
  /// Lists the fonts of these files in the given order. Throws InputError for a file that is not a font, and
  /// for an empty list.
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
