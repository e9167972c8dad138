// Labels beside what they name: none covers another, no leaders cross, all are in the picture, and a small
// turn of the view changes little.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "client/render/projection.h"
#include "client/render/text_layout.h"
#include "client/view/body_mesh.h"
#include "client/view/camera.h"
#include "client/view/part_labels.h"
#include "client/view/surface_tree.h"
#include "common/rotation_between.h"
#include "common/scene/primitives.h"

namespace prosector {
namespace {

constexpr int wide = 800, high = 600;

double uniform(std::mt19937& random, double low, double high_end) {
  return std::uniform_real_distribution<double>(low, high_end)(random);
}

Vec3 direction(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Vec3(normal(random), normal(random), normal(random)).normalized();
}

/// Balls and eggs of all sizes in a heap, each with a name of its own length.
struct Heap {
  static constexpr std::size_t parts = 110;
  DrawList list;
  std::vector<std::string> names;

  Heap() {
    std::mt19937 random(11);
    for (std::size_t k = 0; k < parts; ++k) {
      PartDesc part;
      part.shape = "ellipsoid";
      for (int axis = 0; axis < 3; ++axis) part.size[axis] = uniform(random, 0.015, 0.07);
      list.items.push_back({.mesh = rigid_mesh(mesh_of(part), k + 1),
                            .pose = {0.14 * std::cbrt(uniform(random, 0, 1)) * direction(random),
                                     rotation_between(Vec3::UnitX(), direction(random))},
                            .appearance = {}});
      names.push_back("part " + std::to_string(k) + std::string(k % 23, 'n'));
    }
  }

  std::vector<NamedItem> named() const {
    std::vector<NamedItem> out;
    for (std::size_t k = 0; k < parts; ++k) out.push_back({static_cast<std::uint32_t>(k), k, names[k]});
    return out;
  }

  void look(PartLabels& labels, const Pose& eye, bool stereo = false) {
    list.lines.clear();
    list.texts.clear();
    list.cameras = {mono_camera(eye, 0.8, wide, high)};
    if (stereo) {
      const auto eyes = stereo_cameras(eye, StereoProfile{}, 2 * wide, high);
      list.cameras.assign(eyes.begin(), eyes.end());
    }
    labels.add(list, named(), free());
  }

  static Eigen::AlignedBox2d free() {
    return {Eigen::Vector2d(10, 20), Eigen::Vector2d(wide - 10, high - 50)};
  }
};

Eigen::Vector2d pixel(const DrawCamera& camera, const Vec3& at) {
  const Eigen::Vector4d clip = view_projection_of(camera) * at.homogeneous();
  return {(clip.x() / clip.w() + 1) / 2 * camera.width, (1 - clip.y() / clip.w()) / 2 * camera.height};
}

struct Leader {
  Eigen::Vector2d from, to;
  Vec3 anchor;
};

std::vector<Leader> leaders_of(const DrawList& list, const DrawCamera& camera) {
  std::vector<Leader> out;
  for (const DrawLine& line : list.lines)
    if (line.a != line.b) out.push_back({pixel(camera, line.a), pixel(camera, line.b), line.b});
  out.resize(out.size() / 2);  // each is drawn twice: what it stands out by, and itself
  return out;
}

bool cross(const Leader& a, const Leader& b) {
  const auto side = [](const Leader& line, const Eigen::Vector2d& p) {
    const Eigen::Vector2d u = line.to - line.from, v = p - line.from;
    return u.x() * v.y() - u.y() * v.x();
  };
  return side(a, b.from) * side(a, b.to) < 0 && side(b, a.from) * side(b, a.to) < 0;
}

Eigen::AlignedBox2d ground_of(const PlacedText& text) {
  const Eigen::Vector2d beyond(ground_beside, ground_above);
  return {text.origin - beyond, text.origin + text.size + beyond};
}

void expect_legible(const DrawList& list, Typesetter& typesetter) {
  for (const DrawCamera& camera : list.cameras) {
    const std::vector<PlacedText> texts = place_texts(list, camera, typesetter);
    const std::vector<Leader> leaders = leaders_of(list, camera);
    ASSERT_EQ(texts.size(), leaders.size());
    const Eigen::AlignedBox2d picture(Eigen::Vector2d(0, 0), Eigen::Vector2d(camera.width, camera.height));
    for (std::size_t i = 0; i < texts.size(); ++i) {
      const Eigen::AlignedBox2d ground = ground_of(texts[i]);
      EXPECT_TRUE(picture.contains(ground))
          << texts[i].text->text << " at " << ground.min().transpose() << " to " << ground.max().transpose();
      EXPECT_EQ(texts[i].lift, 0) << texts[i].text->text << " would cover another";
      EXPECT_LT(ground.exteriorDistance(leaders[i].from), 2) << texts[i].text->text << " and its leader";
      for (std::size_t j = 0; j < i; ++j) {
        EXPECT_TRUE(ground.intersection(ground_of(texts[j])).isEmpty())
            << texts[i].text->text << " covers " << texts[j].text->text;
        EXPECT_FALSE(cross(leaders[i], leaders[j]))
            << "the leaders of " << texts[i].text->text << " and " << texts[j].text->text;
      }
    }
  }
}

/// Tells what stands at the anchors, by rays.
void expect_anchors_on_what_is_seen(const Heap& heap, SurfaceTrees& trees) {
  const DrawCamera& camera = heap.list.cameras.front();
  const std::vector<Leader> leaders = leaders_of(heap.list, camera);
  for (std::size_t k = 0; k < leaders.size(); ++k) {
    const Ray ray{camera.pose.p, (leaders[k].anchor - camera.pose.p).normalized()};
    double nearest = 1e9;
    std::size_t item = 0;
    for (std::size_t i = 0; i < heap.list.items.size(); ++i)
      if (const auto hit = trees.meet(ray, heap.list.items[i]); hit && hit->distance < nearest)
        nearest = hit->distance, item = i;
    EXPECT_EQ(heap.names[item], heap.list.texts[k].text);
    EXPECT_NEAR(nearest, (leaders[k].anchor - camera.pose.p).norm(), 0.01);
  }
}

Pose view_of_heap(std::mt19937& random) {
  const Vec3 from = direction(random);
  return look_at(uniform(random, 0.25, 0.9) * from, 0.04 * direction(random));
}

TEST(Labels, DoNotCoverEachOtherAndTheirLeadersDoNotCrossFromAnywhere) {
  Heap heap;
  Typesetter typesetter;
  SurfaceTrees trees;
  PartLabels labels;  // that remember the last view, which is nothing like the next
  std::mt19937 random(5);
  std::size_t most = 0;
  for (int view = 0; view < 60; ++view) {
    heap.look(labels, view_of_heap(random));
    most = std::max(most, heap.list.texts.size());
    expect_legible(heap.list, typesetter);
    if (view < 12) expect_anchors_on_what_is_seen(heap, trees);
    ASSERT_FALSE(testing::Test::HasFailure()) << "view " << view;
  }
  EXPECT_GT(most, 30u);
  EXPECT_LE(most, PartLabels::most_labels);
}

TEST(Labels, HoldThatForBothEyesOfAHeadset) {
  Heap heap;
  Typesetter typesetter;
  PartLabels labels;
  std::mt19937 random(6);
  for (int view = 0; view < 30; ++view) {
    heap.look(labels, view_of_heap(random), true);
    EXPECT_GT(heap.list.texts.size(), 5u);
    expect_legible(heap.list, typesetter);
    ASSERT_FALSE(testing::Test::HasFailure()) << "view " << view;
  }
}

TEST(Labels, StayWhereTheyAreWhileTheViewTurnsALittle) {
  Heap heap;
  Typesetter typesetter;
  PartLabels labels;
  std::map<std::string, Eigen::Vector2d> before;
  constexpr double one_place = 24;  // points: a column that loses or gets a label moves by one
  std::size_t seen = 0, kept = 0, jumped = 0, quiet_steps = 0;
  for (int step = 0; step < 120; ++step) {
    const double turn = 0.25 * step * std::numbers::pi / 180;  // 30° in all
    heap.look(labels, look_at(0.5 * Vec3(std::sin(turn), 0.3, std::cos(turn)), Vec3::Zero()));
    expect_legible(heap.list, typesetter);
    std::map<std::string, Eigen::Vector2d> now;
    const std::size_t jumped_before = jumped;
    for (const PlacedText& text : place_texts(heap.list, heap.list.cameras.front(), typesetter))
      now[text.text->text] = text.origin;
    for (const auto& [name, at] : before) {
      ++seen;
      const auto found = now.find(name);
      if (found == now.end()) continue;
      ++kept;
      if ((found->second - at).norm() > one_place) ++jumped;
    }
    quiet_steps += jumped == jumped_before ? 1 : 0;
    before = now;
  }
  EXPECT_GT(seen, 3000u);
  EXPECT_GT(static_cast<double>(kept), 0.99 * static_cast<double>(seen));
  EXPECT_LT(static_cast<double>(jumped), 0.02 * static_cast<double>(seen));
  EXPECT_GT(quiet_steps, 80u) << "of 120";
}

TEST(Labels, NameNothingThatIsHiddenOrHalfTransparent) {
  Heap heap;
  PartLabels labels;
  for (DrawItem& item : heap.list.items) item.opacity = 0.3;
  heap.list.items[7].opacity = 1;
  heap.look(labels, look_at({0, 0, 0.5}, Vec3::Zero()));
  ASSERT_EQ(heap.list.texts.size(), 1u);
  EXPECT_EQ(heap.list.texts[0].text, heap.names[7]);
}

TEST(LabelLayout, KeepsItsPromisesForAnyAnchors) {
  std::mt19937 random(3);
  LabelOrder order;
  for (int trial = 0; trial < 400; ++trial) {
    const LabelColumns columns{20, 560, 150, 650, 19, 15, 48};
    std::vector<LabelWanted> wanted;
    const int count = trial % 90;
    for (int k = 0; k < count; ++k)
      wanted.push_back({static_cast<std::uint32_t>(k),
                        {uniform(random, 160, 640), uniform(random, -20, 620)},
                        uniform(random, 20, 130),
                        uniform(random, 0, 100)});
    const LabelLayout layout = lay_out_labels(wanted, columns, order);
    EXPECT_EQ(layout.labels.size(), std::min<std::size_t>(static_cast<std::size_t>(count), 48));
    for (std::size_t i = 0; i < layout.labels.size(); ++i) {
      EXPECT_GE(layout.labels[i].box.min().y(), 20 - 1e-9);
      EXPECT_LE(layout.labels[i].box.max().y(), 560 + 1e-9);
      for (std::size_t j = 0; j < i; ++j) {
        EXPECT_TRUE(layout.labels[i].box.intersection(layout.labels[j].box).isEmpty());
        EXPECT_FALSE(leaders_cross(layout.labels[i], layout.labels[j])) << "trial " << trial;
      }
    }
    order = layout.order;
  }
}

TEST(LabelLayout, ShowsTheHeaviestAndKeepsWhatIsShownUntilSomethingIsMuchHeavier) {
  const LabelColumns columns{0, 40, 100, 300, 20, 15, 48};  // room for two on each side
  std::vector<LabelWanted> wanted;
  for (std::uint32_t k = 0; k < 6; ++k) wanted.push_back({k, {110 + 30.0 * k, 10.0 + k}, 50, 10.0 + k});
  const auto shown = [&](const LabelLayout& layout) {
    std::vector<std::uint32_t> ids;
    for (const PlacedLabel& label : layout.labels) ids.push_back(label.id);
    std::ranges::sort(ids);
    return ids;
  };
  LabelLayout layout = lay_out_labels(wanted, columns, {});
  EXPECT_EQ(shown(layout), (std::vector<std::uint32_t>{2, 3, 4, 5}));
  wanted[0].weight = 16;
  layout = lay_out_labels(wanted, columns, layout.order);
  EXPECT_EQ(shown(layout), (std::vector<std::uint32_t>{2, 3, 4, 5}));
  wanted[0].weight = 30;
  layout = lay_out_labels(wanted, columns, layout.order);
  EXPECT_EQ(shown(layout), (std::vector<std::uint32_t>{0, 3, 4, 5}));
}

}  // namespace
}  // namespace prosector
