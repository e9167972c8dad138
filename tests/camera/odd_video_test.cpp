// Films, images and files that are none as cameras: each gives images, or says at once why it can't.

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>
#include <set>
#include <thread>

#include "common/clock.h"
#include "common/error.h"
#include "drivers/camera/base/camera.h"
#include "drivers/camera/devices/shared_camera.h"
#include "drivers/camera/tags/standard_boards.h"
#include "tests/random.h"

namespace prosector {
namespace {

using namespace std::chrono_literals;
using Bytes = std::vector<std::uint8_t>;

cv::Mat noise_image(int width, int height, unsigned seed) {
  cv::Mat out(height, width, CV_8UC3);
  cv::RNG random(seed);
  random.fill(out, cv::RNG::UNIFORM, 0, 255);
  return out;
}

Bytes jpeg_of(const cv::Mat& image) {
  Bytes out;
  cv::imencode(".jpg", image, out);
  return out;
}

Bytes bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

class OddVideo : public testing::Test {
 protected:
  std::string write(const std::string& name, const Bytes& bytes) const {
    const std::filesystem::path file = folder_ / name;
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    return file.string();
  }
  /// Writes a film of noise that has so many images.
  std::string film(const std::string& name, int images) const {
    const std::string file = (folder_ / name).string();
    cv::VideoWriter out(file, cv::CAP_OPENCV_MJPEG, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 100,
                        {64, 48});
    for (int k = 0; k < images; ++k) out.write(noise_image(64, 48, static_cast<unsigned>(k + 1)));
    return file;
  }

  const std::filesystem::path folder_ = testing::TempDir();
};

/// Returns why the file is no camera; empty: it gave that many images, or as many as come in 3 s.
std::string complaint_of(const std::string& file, int images = 3) {
  try {
    const auto camera = open_camera(file);
    std::int64_t last_ns = 0;
    const std::int64_t start_ns = monotonic_ns();
    for (int k = 0; k < images && seconds_since(start_ns) < 3;) {
      const auto frame = camera->next(1s);
      if (!frame) continue;
      EXPECT_GT(frame->image.width, 0);
      EXPECT_EQ(frame->image.rgb.size(),
                3U * static_cast<unsigned>(frame->image.width * frame->image.height));
      EXPECT_GT(frame->time_ns, last_ns);
      last_ns = frame->time_ns;
      ++k;
    }
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST_F(OddVideo, AStillImageIsACameraOfItsRate) {
  const std::string file = (folder_ / "still.png").string();
  cv::imwrite(file, noise_image(1600, 1200, 1));  // opening it takes longer than an image lasts
  const std::int64_t start_ns = monotonic_ns();
  EXPECT_EQ(complaint_of(file, 16), "");
  EXPECT_LT(seconds_since(start_ns), 2.5) << "s for 16 images at 30 a second";
  const auto camera = open_camera("file://" + file);
  const auto first = camera->next(1s), second = camera->next(1s);
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->image.rgb, second->image.rgb);
  EXPECT_GT(second->number, first->number);
}

TEST_F(OddVideo, AFilmOfOneImageStandsStill) {
  EXPECT_EQ(complaint_of(film("one.avi", 1), 5), "");
  EXPECT_EQ(complaint_of(write("one.jpg", jpeg_of(noise_image(64, 48, 1))), 5), "");
  EXPECT_EQ(complaint_of(film("two.avi", 2), 12), "") << "begun anew again and again";
}

TEST_F(OddVideo, WhatHoldsNoImageIsRefusedAtOnce) {
  const std::string pipe = (folder_ / "pipe.avi").string();
  std::filesystem::remove(pipe);
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const Bytes text(5000, 'x');
  Bytes endless = jpeg_of(noise_image(64, 48, 1));  // its header says 65500 × 65500
  for (std::size_t k = 0; k + 8 < endless.size(); ++k)
    if (endless[k] == 0xFF && endless[k + 1] == 0xC0) {
      endless[k + 5] = endless[k + 7] = 0xFF;
      endless[k + 6] = endless[k + 8] = 0xDC;
      break;
    }
  for (const std::string& file :
       {(folder_ / "missing.avi").string(), folder_.string(), pipe, write("empty.avi", {}),
        write("text.mjpeg", text), film("none.avi", 0), write("endless.jpg", endless)}) {
    const std::int64_t start_ns = monotonic_ns();
    const std::string words = complaint_of(file);
    EXPECT_NE(words.find(file), std::string::npos) << words;
    EXPECT_LT(seconds_since(start_ns), 10) << file;
  }
}

/// Returns images of changing sizes, one after the other, as raw Motion-JPEG.
Bytes changing_mjpeg() {
  Bytes out;
  for (int round = 0; round < 3; ++round)
    for (const auto& [width, height] : {std::pair{64, 48}, {1, 1}, {320, 240}, {17, 9}, {2, 300}}) {
      const Bytes jpeg = jpeg_of(noise_image(width, height, static_cast<unsigned>(width + round)));
      out.insert(out.end(), jpeg.begin(), jpeg.end());
    }
  return out;
}

TEST_F(OddVideo, ChangesItsSizeWhileOthersLook) {
  EXPECT_EQ(complaint_of(write("changing.mjpeg", changing_mjpeg()), 20), "");
  SharedCamera camera(write("changing.mjpeg", changing_mjpeg()));
  const auto reader = camera.reader("");
  BoardTracker tracker(find_board("tablet"));
  std::atomic<int> images = 0;
  std::set<int> widths;
  {
    const SharedCamera::Seat seat(
        camera, [&](const Camera& opened) { reader->begin(opened); },
        [&](const Frame& frame) {
          ++images;
          widths.insert(frame.image.width);
          (void)tracker.update(reader->read(frame), reader->optics());
        });
    for (int wait = 0; wait < 500 && images < 20; ++wait) std::this_thread::sleep_for(10ms);
  }
  EXPECT_GE(images, 20);
  EXPECT_EQ(widths, (std::set{64, 1, 320, 17, 2}));
  EXPECT_EQ(camera.state().opened, 1U) << camera.state().problem;
}

TEST_F(OddVideo, IsTruncatedOrOfAnOddRate) {
  const Bytes whole = bytes_of(film("whole.avi", 30));
  ASSERT_GT(whole.size(), 10000U);
  for (const double share : {0.02, 0.3, 0.6, 0.95}) {
    const auto end = static_cast<std::ptrdiff_t>(share * static_cast<double>(whole.size()));
    const std::string file = write("truncated.avi", {whole.begin(), whole.begin() + end});
    const std::string words = complaint_of(file);
    EXPECT_TRUE(words.empty() || words.find(file) != std::string::npos) << words;
    if (share > 0.5) {
      EXPECT_EQ(words, "") << share;
    }
  }
  // The header's scale and rate, whose ratio is images a second.
  const std::string mark = "strh";
  const auto header = std::search(whole.begin(), whole.end(), mark.begin(), mark.end());
  ASSERT_NE(header, whole.end());
  for (const auto& [scale, rate] : {std::pair{0, 0}, {0, 255}, {255, 0}}) {
    Bytes odd = whole;
    const auto at = odd.begin() + (header - whole.begin()) + 8 + 20;
    std::fill_n(at, 4, static_cast<std::uint8_t>(scale));
    std::fill_n(at + 4, 4, static_cast<std::uint8_t>(rate));
    EXPECT_EQ(complaint_of(write("rate.avi", odd)), "") << scale << " " << rate;
  }
}

TEST_F(OddVideo, IsBrokenAnywhere) {
  const std::vector<Bytes> wholes = {bytes_of(film("whole.avi", 8)), changing_mjpeg()};
  Random random(39);  // the seed
  for (int k = 0; k < 12; ++k) {
    Bytes odd = wholes[static_cast<std::size_t>(k) % 2];
    const std::size_t reach = k % 4 < 2 ? 600 : odd.size();  // headers, or all of it
    for (std::size_t hits = 1 + random.below(30); hits > 0; --hits)
      odd[random.below(std::min(reach, odd.size()))] = static_cast<std::uint8_t>(random.below(256));
    const std::string file = write(k % 2 == 0 ? "broken.avi" : "broken.mjpeg", odd);
    const std::string words = complaint_of(file, 2);
    EXPECT_TRUE(words.empty() || words.find(file) != std::string::npos) << k << ": " << words;
  }
}

}  // namespace
}  // namespace prosector
