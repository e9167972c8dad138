// Contacts that no displacement of the tick closes are left out of the solver, and no others.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "server/physics/mechanics/contact/potentials.h"
#include "server/physics/mechanics/coupled/island_joints.h"
#include "tests/physics/scenes.h"
#include "tests/random.h"

namespace prosector::test {
namespace {

constexpr double reach = 4e-3;  // m: gaps are at most this
constexpr int contacts = 500;

/// Two blocks and two rigid bodies with contacts at random places: of blocks with rigid bodies, with the room
/// and with each other.
struct Crowded {
  soft::SoftBody first{block(), make_block({0.1, 0.1, 0.1}, {3, 3, 3})},
      second{block(), make_block({0.1, 0.1, 0.1}, {2, 2, 2})};
  soft::SoftBodyState of_first = first.initial_state(), of_second = second.initial_state();
  coupled::Island island;
  coupled::IslandLayout layout;
  VecX start;

  explicit Crowded(Random& random) {
    island.soft.push_back({0, &first, &of_first});
    island.soft.push_back({1, &second, &of_second});
    island.rigid.resize(2);
    island.rigid[1].slot = 1;
    for (int i = 0; i < contacts; ++i) {
      contact::Contact& c = island.contacts.emplace_back();
      c.a = soft_side(0, random);
      const std::size_t other = random.below(4);
      if (other < 2) {
        c.b.kind = contact::ContactSide::Kind::rigid;
        c.b.body = other;
        c.b.arm = random.point(0.1);
      } else if (other == 2) {
        c.b = soft_side(1, random);
      } else {
        c.b.moved = random.point(1e-3);
      }
      c.normal = random.point(1).normalized();
      c.gap = random.uniform(-reach / 4, reach);
      c.spread = random.uniform(0, reach / 8);
      c.stiffness = random.uniform(10, 1000);
    }
    layout.begin(island);
    start.resize(layout.size);
    start << of_first.motion.x, of_second.motion.x, VecX::Zero(12);
  }

  /// Returns the unknowns after random displacements of up to `most` m or rad.
  VecX moved(Random& random, double most) const {
    return start + VecX::NullaryExpr(start.size(), [&] { return random.uniform(-most, most); });
  }

  /// Returns the contact's gap at the unknowns q, m, from its definition.
  double gap(const contact::Contact& c, const VecX& q) const {
    return c.gap + c.normal.dot(way(c.a, q) - way(c.b, q));
  }

 private:
  contact::ContactSide soft_side(std::size_t body, Random& random) const {
    contact::ContactSide side;
    side.kind = contact::ContactSide::Kind::soft;
    side.body = body;
    const auto nodes = static_cast<std::size_t>((body == 0 ? first : second).nodes());
    const std::size_t count = 1 + random.below(4);
    double sum = 0;
    for (std::size_t k = 0; k < count; ++k) {
      side.node[k] = static_cast<std::uint32_t>((random.below(nodes / 4) + k * (nodes / 4)) % nodes);
      side.weight[k] = k + 1 < count ? random.uniform(-0.3, 1) : 1 - sum;  // quadratic ones are negative, too
      sum += side.weight[k];
    }
    side.nodes = count;
    return side;
  }

  Vec3 way(const contact::ContactSide& side, const VecX& q) const {
    Vec3 out = side.moved;
    if (side.kind == contact::ContactSide::Kind::rigid) {
      const Eigen::Index at = layout.rigid(side.body);
      return out + Vec3(q.segment<3>(at)) + Vec3(q.segment<3>(at + 3)).cross(side.arm);
    }
    for (std::size_t k = 0; k < side.nodes; ++k) {
      const Eigen::Index at = layout.soft[side.body] + 3 * static_cast<Eigen::Index>(side.node[k]);
      out += side.weight[k] * (q.segment<3>(at) - start.segment<3>(at));
    }
    return out;
  }
};

TEST(ContactReach, ListsEveryContactThatPressesAndFewOthers) {
  Random random(test_seed(true));
  for (int round = 0; round < 20; ++round) {
    const Crowded crowded(random);
    coupled::ContactReach found;
    const VecX nodes = crowded.start.head(crowded.layout.rigid_begin);
    found.begin(crowded.island, crowded.layout, nodes);
    for (const double most : {0.0, 1e-6, 1e-4, 3e-5, 1e-3, 1e-2}) {
      const VecX q = crowded.moved(random, most);
      found.cover(q);
      const std::vector<std::uint32_t>& listed = found.listed();
      EXPECT_TRUE(std::is_sorted(listed.begin(), listed.end()));
      for (std::uint32_t c = 0; c < crowded.island.contacts.size(); ++c) {
        const contact::Contact& contact = crowded.island.contacts[c];
        const bool is_listed = std::binary_search(listed.begin(), listed.end(), c);
        EXPECT_TRUE(is_listed || crowded.gap(contact, q) >= contact.spread) << c << " after " << most << " m";
      }
      EXPECT_LT(listed.size(), most < 1e-5 ? contacts / 2 : contacts + 1) << "after " << most << " m";
    }
  }
}

TEST(ContactReach, ChangesNoEnergyAndNoForce) {
  Random random(test_seed(true));
  for (int round = 0; round < 20; ++round) {
    Crowded crowded(random);
    coupled::IslandJoints joints;
    joints.begin(crowded.island, crowded.layout, 1.0 / 60);
    for (const double most : {1e-6, 1e-4, 3e-5, 1e-3, 1e-2}) {
      const VecX q = crowded.moved(random, most);
      double energy = 0, expected = 0;
      joints.add_energy(q, energy);
      joints.write_joint_forces(q, false);
      for (const contact::Contact& c : crowded.island.contacts) {
        const contact::EvenSpring spring{c.stiffness, c.spread};
        expected += spring.energy(crowded.gap(c, q));
        EXPECT_NEAR(c.force, -spring.slope(crowded.gap(c, q)), 1e-9);
      }
      EXPECT_NEAR(energy, expected, 1e-12 * std::abs(expected) + 1e-12);
    }
  }
}

}  // namespace
}  // namespace prosector::test
