#pragma once
// How much of what a picture is about other things hide, by a depth buffer of item numbers on the processor.

#include <set>
#include <vector>

#include "client/view/draw_list.h"

namespace prosector::test {

/// Sorts the items of a list, by the ids of their meshes.
struct CoverSubject {
  std::set<std::uint64_t> anatomy;  // what is to be seen
  std::set<std::uint64_t> bodies;   // the room and all bodies: what they hide counts as out of sight anyway
};

struct Cover {
  std::size_t pixels = 0;  // in which the anatomy would be seen, without what covers it
  double by_items = 0;     // share of them behind own hands, sleeves and boards, each times its opacity
  double opaque = 0;       // the same as if all of that were opaque
  double by_texts = 0;     // share of them behind the grounds of texts
  std::vector<std::size_t> near;  // items of those that are cut open by the near plane, within the picture

  double all() const { return by_items + by_texts; }
};

/// A pixel of the picture, from its top left, where the anatomy would be seen.
using AnatomyPixels = std::vector<Eigen::Vector2d>;

/// Measures the list's picture by its first camera, at a resolution of `longest` pixels. `seen`: where the
/// anatomy would be seen, in pixels of the camera; null: not wanted.
Cover cover_of(const DrawList& list, const CoverSubject& subject, int longest, AnatomyPixels* seen = nullptr);

}  // namespace prosector::test
