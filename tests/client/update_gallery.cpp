// Draws the golden pictures anew: update_gallery FOLDER [SCALE]. Look at them before you commit them.

#include <fmt/format.h>

#include <cstdlib>

#include "tests/client/gallery.h"
#include "tests/client/picture.h"

int main(int argc, char** argv) {
  using namespace prosector;
  if (argc < 2) {
    fmt::print(stderr, "update_gallery FOLDER [SCALE]\n");
    return 1;
  }
  const int scale = argc > 2 ? std::atoi(argv[2]) : 1;
  for (const std::string& name : test::gallery_names()) {
    test::GalleryPicture picture = test::gallery_picture(name);
    for (DrawCamera& camera : picture.list.cameras) {
      camera.width *= scale;
      camera.height *= scale;
    }
    const std::filesystem::path file = std::filesystem::path(argv[1]) / (picture.name + ".png");
    write_png(test::picture_of(picture.list, scale * picture.width, scale * picture.height), file);
    fmt::print("{}\n", file.string());
  }
}
