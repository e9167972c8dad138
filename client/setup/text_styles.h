#pragma once
// Text styles of the set-up window's pages: headings, side notes and warnings.

#include <string>

namespace prosector {

/// Message of a set-up page, shown below the pages until another one replaces it.
struct Said {
  std::string words;
  bool wrong = false;  // an error message
};

void title(const std::string& words);
void wrapped(const std::string& words);
void quiet(const std::string& words);
void warning(const std::string& words);

/// Leaves below the text just drawn at least the space that `other` would need in its place, so that what
/// follows does not move while such texts replace each other.
void keep_space_for(const std::string& other);

}  // namespace prosector
