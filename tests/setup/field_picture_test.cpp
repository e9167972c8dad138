// A bent field as a person sees it.
#include "client/setup/field_plot.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <cstdlib>

#include "client/render/image.h"
#include "client/render/shader_dir.h"

namespace prosector::test {
namespace {

/// Returns samples of a grid whose reports go astray near its right side.
std::vector<FieldSample> astray() {
  std::vector<FieldSample> out;
  for (int i = 0; i < 125; ++i) {
    const Vec3 p = 0.15 * (Vec3(i % 5, i / 5 % 5, i / 25) - Vec3(2, 2, 2));
    const Vec3 from_metal = p - Vec3(0.6, 0.1, 0);
    const double d = from_metal.norm();
    out.push_back({{p + 1.2e-3 * from_metal / (d * d * d * d), Quat::Identity()}, {p, Quat::Identity()}});
  }
  return out;
}

TEST(FieldPicture, ShowsWhatWasOffAndWhatIsLeft) {
  const std::vector<FieldSample> samples = astray();
  const FieldPicture picture = picture_of(samples, fit_field(samples));
  ASSERT_EQ(picture.places.size(), samples.size());
  double before = 0, after = 0;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    EXPECT_LT((picture.before[k] - (samples[k].reported.p - samples[k].truth.p)).norm(), 1e-12);
    before += picture.before[k].squaredNorm();
    after += picture.after[k].squaredNorm();
  }
  EXPECT_LT(after, 0.1 * before);
  for (const double scale : {1., 2.}) {
    const int wide = static_cast<int>(700 * scale), high = static_cast<int>(340 * scale);
    const auto context = make_offscreen_context(wide, high);
    Interface ui(*context, default_shader_dir(), scale);
    for (int k = 0; k < 3; ++k)
      ui.draw(1. / 30, [&] {
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
        ImGui::Begin("field", nullptr, ImGuiWindowFlags_NoDecoration);
        draw_field_picture(ui, picture);
        ImGui::End();
      });
    const Image image = ui.read_pixels();
    if (const char* folder = std::getenv("PROSECTOR_PICTURES"))
      write_png(image, std::filesystem::path(folder) / (scale == 1 ? "field-1x.png" : "field-2x.png"));
    // Red is what is far off: on the left half alone.
    int red_before = 0, red_after = 0;
    for (int y = 0; y < high; ++y)
      for (int x = 0; x < wide; ++x) {
        const auto pixel = image.pixel(x, y);
        if (pixel[0] > 180 && pixel[1] < 110 && pixel[2] < 110) ++(x < wide / 2 ? red_before : red_after);
      }
    EXPECT_GT(red_before, 100);
    EXPECT_EQ(red_after, 0);
  }
}

}  // namespace
}  // namespace prosector::test
