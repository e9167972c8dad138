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

const std::vector<std::string>& gallery_names();
GalleryPicture gallery_picture(const std::string& name);

}  // namespace prosector::test
