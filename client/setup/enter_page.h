#pragma once
// The page by which one enters a session, or hosts one.

#include <map>
#include <string>

#include "client/setup/anteroom.h"
#include "client/setup/interface.h"

namespace prosector {

class EnterPage {
 public:
  void draw(Interface& ui, Anteroom& room);

 private:
  std::string session_;        // chosen among those that were found
  std::size_t scene_ = 0;      // chosen to host
  bool scene_chosen_ = false;  // the one that was hosted last was looked for
  std::string hosted_name_ = "anatomy";
  std::string own_scene_;  // a file that somebody typed
  std::map<std::string, void*> textures_;

  void draw_person(Interface& ui, Anteroom& room);
  void draw_sessions(Interface& ui, Anteroom& room);
  void draw_session(Interface& ui, Anteroom& room, const FoundSession& session);
  void draw_scenes(Interface& ui, Anteroom& room);
  void draw_hosting(Interface& ui, Anteroom& room);
  void* picture(Interface& ui, const ListedScene& scene);
};

}  // namespace prosector
