#pragma once
// A desk whose window a test acts in, above a floor.

#include <gtest/gtest.h>

#include <chrono>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "client/app/desk/desk.h"
#include "client/view/camera.h"
#include "tests/client/acted_window.h"

namespace prosector::test {

class AtTheDesk : public testing::Test {
 protected:
  ActedWindow window;
  Desk desk{window, {}};
  const Vec3 target{0, 1, 0};
  DeskSession session;

  void SetUp() override {
    DeskStart start;
    start.home = place_of({0, 1.5, 1}, target);
    start.views[3] = ViewPlace{target, 0, max_view_pitch, 2};
    desk.begin(start);
    session.is_soft = [](BodyId) { return true; };
    // A floor at the target's height.
    session.room.surface = [this](const Ray& ray) -> std::optional<Picked> {
      const double distance = (target.y() - ray.from.y()) / ray.along.y();
      if (!(distance > 0)) return std::nullopt;
      return Picked{{distance, ray.from + distance * ray.along, Vec3::UnitY()}, 0};
    };
    session.room.box = [](BodyId) { return Eigen::AlignedBox3d(Vec3(-1, 0.9, -1), Vec3(1, 1, 1)); };
  }
  void update() { desk.update(session); }
  void wait(int milliseconds) {
    for (int k = 0; k < milliseconds; k += 10) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      session.physical_hand = desk.input().hands[right_hand].pose;
      update();
    }
  }
  void hold(Key key, const std::vector<WindowEvent>& meanwhile) {
    window.events.push_back(KeyEvent{key, true, false});
    window.events.insert(window.events.end(), meanwhile.begin(), meanwhile.end());
    window.events.push_back(KeyEvent{key, false, false});
    update();
  }
  std::vector<WindowEvent> drag(double x, double y) {
    window.drag_right(x, y);
    return std::exchange(window.events, {});
  }
  double distance() const { return (desk.view().eye().p - target).norm(); }
  void press(Key key) {
    window.press(key);
    update();
  }
};

}  // namespace prosector::test
