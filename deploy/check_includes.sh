#!/usr/bin/env bash
# Who may include whom (docs/understand/architecture.md): each rule is files, what they must not include, and why.
set -euo pipefail
cd "$(dirname "$0")/.."

bad=0
# forbid WHY REGEX FILES...: no file may hold an #include whose path matches REGEX.
forbid() {
  local why=$1 regex=$2
  shift 2
  [ $# -gt 0 ] || return 0
  if grep -nHE "^[[:space:]]*#[[:space:]]*include[[:space:]]*[<\"]($regex)" "$@"; then
    echo "  ^ $why"
    bad=1
  fi
}

# only WHY REGEX ALLOWED FILES...: what files include of REGEX must match ALLOWED, too.
only() {
  local why=$1 regex=$2 allowed=$3
  shift 3
  if grep -nHE "^[[:space:]]*#[[:space:]]*include[[:space:]]*[<\"]($regex)" "$@" | grep -vE "[<\"]($allowed)"; then
    echo "  ^ $why"
    bad=1
  fi
}

# sources PATTERN [EXCEPT]: our C++ files below folders matching PATTERN, without those matching EXCEPT.
all=$(git ls-files --cached --others --exclude-standard '*.h' '*.cpp')
sources() { grep -E "^($1)" <<<"$all" | { if [ $# -gt 1 ]; then grep -vE "$2"; else cat; fi; } || true; }

forbid "common includes nothing of ours but common" '(idl|drivers|twins|server|client|tests)/' $(sources common/)
forbid "idl includes common only" '(drivers|twins|server|client|tests)/' $(sources idl/)
forbid "drivers include common only; drivers/open_camera.cpp also opens the synthetic camera" '(idl|twins|server|client|tests)/' \
  $(sources drivers/ '^drivers/open_camera\.cpp$')
forbid "simulated devices know neither sessions nor the client's configuration nor the drivers that they test" \
  '(idl|server|client|tests|drivers/(config|device|fitting|gamepad|gloves|trackers))/' $(sources twins/)
forbid "the server never knows a device or a client" '(drivers|twins|client|tests)/' $(sources server/)
forbid "the client never knows the server" '(server|tests)/' $(sources client/)
forbid "the client knows no simulated device; record_camera.cpp reads the clock that a synthetic camera paints" 'twins/' \
  $(sources client/ '^client/app/commands/record_camera\.cpp$')
forbid "physics and its calibration know no network and no session" '(idl|server/session)/' \
  $(sources 'server/(physics|calibration)/')
forbid "of idl, others include its bus headers only: idl/wire and idl/dds are its own" 'idl/(wire|dds)/' \
  $(sources '(server|client)/')
forbid "the client knows no particular device: devices and arms are opened by address" 'drivers/(trackers|gloves|arms)/' \
  $(sources client/)
only "the view through a camera knows cameras and devices' interface" 'drivers/' 'drivers/(camera|device)/' $(sources client/ar/)
forbid "a camera's sight knows neither sessions nor what is drawn with" 'client/(app|replica|render|setup)/' $(sources client/ar/)
forbid "drivers know nothing of calibration but what it fits" 'drivers/fitting/' $(sources drivers/ '^drivers/fitting/')
forbid "OpenIGTLink only in drivers/protocols/igtl_messages.cpp" 'igtl_(header|tdata|transform|util)\.h' \
  $(sources '(common|idl|drivers|twins|server|client)/' '^drivers/protocols/igtl_messages\.cpp$')
forbid "XNNPACK only in drivers/camera/nets/network.cpp" '(xnnpack|pthreadpool)\.h' \
  $(sources '(common|idl|drivers|twins|server|client)/' '^drivers/camera/nets/network\.cpp$')
forbid "only idl knows DDS" '(dds/|ddsc/|prosector\.h)' $(sources '(common|drivers|server|client)/')
# bullet_types.h hands Bullet on, so including it counts as including Bullet.
forbid "Bullet only in server/physics/mechanics/rigid, panel_motion.cpp, convex_hull.cpp and the contact .cpp files of server/physics" \
  '(bullet/|bt[A-Z]|Bullet(Collision|Dynamics)|LinearMath|.*/bullet_types\.h)' \
  $(sources '(common|idl|drivers|client|server/session)/') \
  $(sources server/physics/ '^server/physics/(mechanics/(rigid/|panel/panel_motion\.cpp|collision/shapes/convex_hull\.cpp)|.*contact[a-z_/]*\.cpp$)')
# below BASE FOLDERS...: of BASE's folders, each includes only itself and those before it, and no file that lies in BASE
# itself: such files include all of them.
below() {
  local base=$1 folder later
  shift
  forbid "what lies in $base beside its folders knows them all" "$base/[a-z0-9_]+\.h" $(sources "$base/[a-z0-9_]+/")
  while [ $# -gt 1 ]; do
    folder=$1
    shift
    later=$(IFS='|'; echo "$*")
    forbid "$base/$folder includes of $base's folders only itself and those before it" "$base/($later)/" $(sources "$base/$folder/")
  done
}
below server/physics base mechanics world stations
below server/session people journal sending recording run
below client/app session terminal output desk user commands run
below drivers/camera base tags capture nets hands face calibration devices printing
below server/physics/mechanics soft collision cutting rigid contact hands panel organs coupled
below server/physics/mechanics/soft base simd laws elements springs matrices solvers integrators xpbd
below server/physics/mechanics/collision primitives surface shapes narrow outlines broad
below server/physics/stations touching hands parts panels dissecting islands compile save
for part in soft collision; do
  only "$part knows nothing of the rest of physics but threads and edits of lists" 'server/' \
    "server/physics/(mechanics/$part/|base/(parallel|list_edit|surface_edit)\\.h)" $(sources "server/physics/mechanics/$part/")
done
only "cutting knows collision, and nothing else of physics but threads" 'server/' \
  'server/physics/(mechanics/(cutting|collision)/|base/parallel\.h)' $(sources server/physics/mechanics/cutting/)
forbid "TBB's loops only in server/physics/base/fork_join.h, which has others for the thread sanitizer" 'tbb/parallel_' \
  $(sources '(common|idl|drivers|twins|server|client)/' '^server/physics/base/fork_join\.h$')
forbid "fork_join.h only by parallel.h: its ranges depend on the threads" 'server/physics/base/fork_join\.h' \
  $(sources '(common|idl|drivers|twins|server|client)/' '^server/physics/base/parallel\.h$')
forbid "OpenGL only in client/render; OpenXR asks for EGL's types" '(GL/|GLFW/|EGL/|GLES)' \
  $(sources '(common|idl|drivers|twins|server)/' '^twins/openxr/') \
  $(sources client/ '^client/(render/|xr/xr_api\.h$)')
forbid "OpenXR only in client/xr/xr_api.h and in the simulated runtime" 'openxr/(openxr|openxr_[a-z_]*)\.h' \
  $(sources '(common|idl|drivers|twins|server|client)/' '^(client/xr/xr_api\.h|twins/openxr/simulated_runtime\.h)$')
forbid "what of client/xr knows OpenXR is its own" 'client/xr/xr_' $(sources client/ '^client/xr/(xr_[a-z_]*\.(h|cpp)|headset\.cpp)$')
forbid "a headset knows neither sessions nor the desk" 'client/(app|replica|setup)/' $(sources client/xr/)
forbid "Dear ImGui only in the .cpp files of client/setup" 'imgui' \
  $(sources '(common|idl|drivers|twins|server|client)/' '^client/setup/[a-z_]*\.cpp$')
forbid "the set-up window starts programs: it knows neither sessions from inside nor the desk" 'client/(app|replica|view)/' $(sources client/setup/)
forbid "FreeType, HarfBuzz, FriBidi and fontconfig only in the .cpp files of client/text" '(ft2build|hb|fribidi|fontconfig/)' \
  $(sources '(common|idl|drivers|twins|server|client)/' '^client/text/[a-z_]*\.cpp$')
forbid "the languages of the client know common only" '(idl|drivers|server|tests|client/[a-km-z])/' $(sources client/language/)
forbid "text knows neither what is drawn nor how" 'client/(app|render|replica|view)/' $(sources client/text/)
forbid "toml++, assimp, OpenCV and SQLite only in .cpp files" '(toml\+\+|assimp/|opencv|sqlite3)' \
  $(sources '(common|idl|drivers|twins|server|client)/' '(\.cpp|^drivers/camera/base/with_cv\.h)$')
forbid "what turns OpenCV's types into ours only in .cpp files" 'drivers/camera/base/with_cv' \
  $(sources '(common|idl|drivers|twins|server|client)/' '\.cpp$')
forbid "libapriltag only in drivers/camera/tags/tag_detector.cpp" 'apriltag/' \
  $(sources '(common|idl|drivers|twins|server|client)/' '^drivers/camera/tags/tag_detector\.cpp$')
forbid "image processing knows no device; drivers/camera/devices makes devices of it" 'drivers/(device|config|fitting|trackers|gloves|arms)/' \
  $(sources drivers/camera/ '^drivers/camera/devices/')

# Debian's packages of Python's modules are for its own interpreter, which need not be the first on PATH.
if git ls-files --cached --others --exclude-standard '*.py' | xargs grep -nHE '^#!.*python' | grep -v ':1:#!/usr/bin/python3$'; then
  echo "  ^ programs in Python begin with #!/usr/bin/python3"
  bad=1
fi

# deploy/build.sh counts the steps by a dry run of Ninja, which shows only the check of such globs. It configures every time.
if git ls-files '*CMakeLists.txt' '*.cmake' | xargs grep -nE 'GLOB.*CONFIGURE_DEPENDS'; then
  echo "  ^ no CONFIGURE_DEPENDS in file(GLOB)"
  bad=1
fi

[ $bad -eq 0 ] || { echo "includes: move the code or the seam, not the rule" >&2; exit 1; }
echo "includes: good"
