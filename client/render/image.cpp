#include "client/render/image.h"

#include <fmt/format.h>
#include <png.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "common/error.h"

namespace prosector {
namespace {

png_image png_header() {
  png_image png;
  std::memset(&png, 0, sizeof png);
  png.version = PNG_IMAGE_VERSION;
  return png;
}

}  // namespace

void write_png(const Image& image, const std::filesystem::path& file) {
  const std::size_t bytes =
      3 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  if (image.width < 1 || image.height < 1 || image.rgb.size() != bytes)
    throw InputError(fmt::format(
        "{}: cannot write the image: its size of {} × {} pixels is empty or does not match its data",
        file.string(), image.width, image.height));
  png_image png = png_header();
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = PNG_FORMAT_RGB;
  // Not png_image_write_to_file, because it deletes the file on failure, even a device.
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> out(std::fopen(file.c_str(), "wb"), std::fclose);
  if (!out) throw InputError(fmt::format("{}: cannot write: {}", file.string(), std::strerror(errno)));
  if (!png_image_write_to_stdio(&png, out.get(), 0, image.rgb.data(), 0, nullptr) ||
      std::fflush(out.get()) != 0)
    throw InputError(fmt::format("{}: cannot write PNG: {}", file.string(),
                                 png.message[0] != 0 ? png.message : std::strerror(errno)));
}

Image read_png(const std::filesystem::path& file) {
  png_image png = png_header();
  if (!png_image_begin_read_from_file(&png, file.c_str()))
    throw InputError(fmt::format("{}: cannot read PNG: {}", file.string(), png.message));
  png.format = PNG_FORMAT_RGB;
  Image image{static_cast<int>(png.width), static_cast<int>(png.height), {}};
  image.rgb.resize(PNG_IMAGE_SIZE(png));
  if (!png_image_finish_read(&png, nullptr, image.rgb.data(), 0, nullptr))
    throw InputError(fmt::format("{}: cannot read PNG: {}", file.string(), png.message));
  return image;
}

}  // namespace prosector
