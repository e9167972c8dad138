#include "client/app/run/stage.h"

#include <sys/resource.h>

namespace prosector {
namespace {

// Lowers the render threads' priority: on a shared machine frames can wait, physics can't. Threads started
// later (the software renderer's) inherit it; the threads for hands and snapshots already run.
void lower_render_priority() {
  setpriority(PRIO_PROCESS, 0, 5);
}

}  // namespace

std::unique_ptr<Stage> make_stage(ViewerContext& client, HeadsetUser& user,
                                  const std::shared_ptr<SharedCamera>& camera) {
  const ClientOptions& o = client.options;
  if (o.display.kind == Display::none) return nullptr;
  lower_render_priority();
  auto stage = std::make_unique<Stage>();
  stage->mode = make_view_mode({client, stage->scene, user, camera});
  stage->renderer =
      std::make_unique<Renderer>(stage->mode->context(), o.rendering.shaders, o.rendering.quality.settings);
  return stage;
}

}  // namespace prosector
