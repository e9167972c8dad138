#pragma once
// Text normalised for searching: without case and diacritics.

#include <string>
#include <string_view>

namespace prosector {

/// Returns the search key of a UTF-8 text: "Große Drüse" and "GROSSE DRUSE" have equal keys, as have "sağ"
/// and "sag". Letters are canonically decomposed (Unicode), marks are removed, and case is folded. Leading
/// and trailing blanks are removed; several blanks between words become one.
std::u32string search_key(std::string_view utf8);

/// Returns whether `key` contains each word of `searched`, anywhere and in any order. Both must be results of
/// search_key(). An empty `searched` matches every key.
bool is_found(std::u32string_view key, std::u32string_view searched);

}  // namespace prosector
