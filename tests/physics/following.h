#pragma once
// Bodies of an organ that follow strokes at random, pieces that come off and strokes that are taken back.

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "server/physics/mechanics/contact/tissue_surface.h"
#include "server/physics/mechanics/organs/organ.h"
#include "server/physics/mechanics/soft/soft_body.h"

namespace prosector {

std::vector<Vec3> rest_of(const organs::Organ& organ);  // m, of its nodes, by id

/// A body with what the simulation hangs on its surface.
struct Hung {
  std::unique_ptr<soft::SoftBody> solver;
  Numbering numbering;
  std::optional<contact::TissueSurface> surface;

  /// After the solver was made.
  void make_surface();
  /// After the solver took in a change that no edit of the surface tells of.
  void remake_surface();
  /// After the solver took the edit in.
  void follow(const SurfaceEdit& edit, Numbering now);

 private:
  void fit();
};

/// Whether all that a step would ask of them is the same, bit for bit, at places that only `seed` tells.
::testing::AssertionResult same_answers(soft::SoftBody& followed, soft::SoftBody& rebuilt, unsigned seed);

/// Whether what hangs on a surface is the same, bit for bit.
::testing::AssertionResult same_contact(Hung& followed, Hung& rebuilt);

/// Where the surface meets itself, crumpled in a way that `seed` changes a little.
std::vector<contact::VertexMeeting> meetings_when_crumpled(Hung& body, unsigned seed);

class FollowingBodies {
 public:
  /// Of bodies `stiffness` times as stiff as described, since they were made.
  FollowingBodies(organs::Organ& cut, const SoftDesc& description, double stiffness)
      : organ(cut), desc(description), stiffness_(stiffness) {}
  virtual ~FollowingBodies() = default;

  struct Stroke {
    std::function<std::vector<Vec3>(double)> edge;  // m, from 0 to 1
    int ticks = 0;
  };
  /// Makes so many, each fourth after the last one was undone, and then takes all back. Stops at what differs
  /// from what is made anew.
  void make_strokes(unsigned count, const std::function<Stroke(unsigned)>& next);

  std::size_t cuts = 0, of_pieces = 0;  // followed in one piece, the organ's or one that came off
  std::size_t fell_apart = 0, taken_back = 0, joined = 0;  // followed by what stayed
  std::size_t not_followed = 0;                            // by what stayed
  std::size_t meetings = 0;                                // of surfaces with themselves, when compared

 protected:
  virtual bool can_follow(const organs::PieceEdit& edit) const = 0;
  /// A cut in one piece, which the organ has not followed yet.
  virtual void follow_cut(const organs::PieceEdit& edit) = 0;
  virtual void follow_change(const organs::PieceEdit& edit, const organs::Regrouped& changed) = 0;
  /// Whether the body's solver is.
  virtual ::testing::AssertionResult same(std::size_t body, Hung& rebuilt, unsigned seed) = 0;
  virtual void end_stroke() {}

  organs::Organ& organ;
  const SoftDesc& desc;
  std::map<std::size_t, Hung> bodies;

 private:
  Hung rebuild(std::size_t body) const;
  void regroup(bool undone);
  void compare(std::size_t body);
  double stiffness_;
  unsigned compared_ = 0;
};

}  // namespace prosector
