#pragma once
// Pictures that golden images are kept of.

#include <string>
#include <vector>

#include "client/view/draw_list.h"

namespace prosector::test {

struct GalleryPicture {
  std::string name;
  int width, height;
  DrawList list;
};

std::vector<GalleryPicture> gallery();

}  // namespace prosector::test
