#!/usr/bin/env bash
# Installs, builds and runs the release suite: every test but those of deploy/left_out.txt. --all also builds and runs the
# tests under the address and undefined-behaviour sanitizers. Ends with the minutes of each phase and the skipped tests,
# by name and reason.
set -euo pipefail
cd "$(dirname "$0")/.."

sanitized=no
for option in "$@"; do
  case $option in
    --all) sanitized=yes ;;
    -h | --help) echo "usage: deploy/test.sh [--all]"; exit 0 ;;
    *) echo "test: unknown option $option; usage: deploy/test.sh [--all]" >&2; exit 2 ;;
  esac
done

export LC_ALL=C.UTF-8  # programs speak English, as tests read
export PROSECTOR_WERROR=ON
phases=() reports=()
phase="" began=0

# step NAME: ends the phase before it.
step() {
  [ -z "$phase" ] || phases+=("$(printf '%3d min %02d s  %s' $(((SECONDS - began) / 60)) $(((SECONDS - began) % 60)) "$phase")")
  phase=$1 began=$SECONDS
  [ -z "$phase" ] || printf '\n== %s (%d min %02d s)\n' "$phase" $((SECONDS / 60)) $((SECONDS % 60))
}

# summary: also where a phase failed.
summary() {
  local status=$?
  [ $status -eq 0 ] || echo "test: failed in: $phase" >&2
  step ""
  printf '\n== duration of each phase\n'
  printf '%s\n' "${phases[@]}"
  printf '%3d min %02d s  in total\n' $((SECONDS / 60)) $((SECONDS % 60))
  [ ${#reports[@]} -eq 0 ] || deploy/test_report.py --slowest 10 "${reports[@]}"
  command -v ccache >/dev/null && ccache --show-stats | sed -n '1,4p'
  exit $status
}
trap summary EXIT

# run_tests PRESET WHERE CTEST_FILTER...: all that the filters choose but what WHERE of deploy/left_out.txt leaves out.
run_tests() {
  local preset=$1 where=$2 build=$PWD/build/$1
  shift 2
  rm -f "$build/tests.xml"
  reports+=("$preset=$build/tests.xml")
  # shellcheck disable=SC2086
  deploy/left_out.py stay "$build" $where -- "$@" >"$build/gate_tests"
  ctest --test-dir "$build" --output-on-failure -j2 -I "$build/gate_tests" --output-junit "$build/tests.xml" \
    --test-output-size-passed 1000000 "$@" || {
    echo "test: see above; repeat with: ctest --test-dir build/$preset --rerun-failed --output-on-failure" >&2
    return 1
  }
  # shellcheck disable=SC2086
  echo "test: deferred to deploy/nightly.sh: $(deploy/left_out.py list "$build" $where -- "$@" | wc -l) tests"
}

step "set-up"
deploy/setup.sh
deploy/fetch_anatomy.sh
deploy/fetch_models.sh
step "include rules and layout"
deploy/check_includes.sh
deploy/check_folders.py
deploy/check_types.py
deploy/check_assertions.py
deploy/check_format.sh
deploy/check_docs.py
deploy/changelog.py check
deploy/check_language.py
deploy/check_comments.py
step "build: release"
deploy/build.sh release
step "tests: release"
run_tests release "all package"
if [ $sanitized = yes ]; then
  step "build: address and undefined-behaviour sanitizers"
  # What tests/*/CMakeLists.txt call SANITIZED, but not what deploy/slow_sanitized.txt lists.
  deploy/build.sh asan sanitized_tests
  step "tests: address and undefined-behaviour sanitizers"
  run_tests asan "all asan" -L '^sanitized_'
fi
echo "test: all tests passed"
