#pragma once
// The page for entering or hosting a session.

#include <map>
#include <string>

#include "client/setup/interface.h"
#include "client/setup/setup_session.h"

namespace prosector {

class EnterPage {
 public:
  void draw(Interface& ui, SetupSession& room);

 private:
  std::string session_;        // the selected one of the found sessions
  std::size_t scene_ = 0;      // index of the scene to host
  bool scene_chosen_ = false;  // the last hosted scene was selected
  std::string hosted_name_ = "anatomy";
  std::string own_scene_;  // path entered by the user
  std::map<std::string, void*> textures_;

  void draw_person(Interface& ui, SetupSession& room);
  void draw_sessions(Interface& ui, SetupSession& room);
  void draw_session(Interface& ui, SetupSession& room, const FoundSession& session);
  void draw_scenes(Interface& ui, SetupSession& room);
  void draw_hosting(Interface& ui, SetupSession& room);
  void* picture(Interface& ui, const ListedScene& scene);
};

}  // namespace prosector
