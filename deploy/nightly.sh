#!/usr/bin/env bash
# The long runs that deploy/test.sh has no time for; docs/do/nightly.md says how to read what it leaves.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
cd "$root"
parts=(package learn mice asan tsan seeds play)

usage() {
  cat <<TXT
deploy/nightly.sh [--hours N] [--only PART]... [--out DIR] [--list]
  PART         package  the Debian packages in a bare root (docs/do/packages.md)
               learn    the lessons of docs/learn, in real windows, at a person's pace
               mice     two simulated users in real windows, with mouse and keyboard, half an hour per shipped scene
               asan   every test under the address and undefined-behaviour sanitizers, all their checks on
               tsan   multi-threaded tests, under the thread sanitizer
               seeds  randomised tests, repeated with new seeds: optimised, and under sanitizers if \`asan\` built them
               play   deploy/play.sh
  --hours N    ends after N hours (default 16): a part that takes longer is stopped and counts as failed;
               \`seeds\` and \`play\` share the remaining time
  --out DIR    figures.json, table.md, each run's log (default out/nightly)
  --list       prints each part's tests, where built, and runs nothing
TXT
}

refuse() { echo "nightly: $1" >&2; usage >&2; exit 2; }

hours=16 out=$root/out/nightly list=no chosen=()
while [ $# -gt 0 ]; do
  case "$1" in
    --hours) hours=${2:-}; shift ;;
    --out) out=${2:?--out needs a folder}; shift ;;
    --only)
      case " ${parts[*]} " in
        *" ${2:-} "*) chosen+=("$2"); shift ;;
        *) refuse "--only ${2:-}: expected one of: ${parts[*]}" ;;
      esac ;;
    --list) list=yes ;;
    -h | --help) usage; exit 0 ;;
    *) refuse "$1 is no option" ;;
  esac
  shift
done
[[ $hours =~ ^[0-9]+(\.[0-9]+)?$ ]] || refuse "--hours $hours: expected a number of hours, such as 16 or 0.5"
limit=$(awk -v hours="$hours" 'BEGIN { printf "%d", 3600 * hours }')
[ "$limit" -gt 0 ] || refuse "--hours $hours: expected more than a second"
[ ${#chosen[@]} -gt 0 ] || chosen=("${parts[@]}")

left() { echo $((limit - SECONDS)); }
is_chosen() { [[ " ${chosen[*]} " == *" $1 "* ]]; }
is_built() { ls "build/$1/bin/"test_* >/dev/null 2>&1; }
threaded='^(session|idl|idl_fuzz|replica|offer|headset|setup)\.'
threaded_tests() { printf '%s\n' test_session test_idl test_idl_fuzz test_replica test_offer test_headset test_setup; }

if [ $list = yes ]; then
  is_built release && ctest --test-dir build/release -N -L '^package$' | sed -n 's/^ *Test *#[0-9]*: /package: /p'
  for preset in release asan-full; do
    is_built $preset && deploy/left_out.py list build/$preset all | sed "s/^/seeds, $preset: /"
  done
  is_built asan-full && ctest --test-dir build/asan-full -N | sed -n 's/^ *Test *#[0-9]*: /asan: /p'
  is_built tsan && ctest --test-dir build/tsan -N -R "$threaded" | sed -n 's/^ *Test *#[0-9]*: /tsan: /p'
  exit 0
fi

mkdir -p "$out"
rm -f "$out"/*.log "$out"/*.xml "$out"/*.tests "$out"/runs.tsv
export PROSECTOR_WERROR=ON

# record PART SEED STATUS SECONDS REPORT: one run. SEED and REPORT: - for none.
record() { printf '%s\t%s\t%s\t%s\t%s\n' "$@" >>"$out/runs.tsv"; }

# bounded SECONDS COMMAND...: also ends what the command started, as an interrupt of this script does.
child=""
bounded() {
  timeout --kill-after=20 "$@" &
  child=$!
  wait "$child"
}
trap '[ -z "$child" ] || kill "$child" 2>/dev/null; exit 130' INT TERM

# every_test PRESET: the targets of all tests.
every_test() {
  ninja -C "build/$1" -t targets all | sed -n 's/^\(test_[a-z0-9_]*\): phony$/\1/p' | grep -vx test_bench_json | sort -u
}

# everything PRESET: what a plain build makes.
everything() { echo all; }

# build_for PART PRESET LIST: what the function LIST prints. False, and recorded, where it fails.
build_for() {
  local began=$SECONDS targets log=$out/build-$1-$2.log
  echo "nightly: building $2"
  if cmake --preset "$2" -DPROSECTOR_WERROR=ON >"$log" 2>&1; then
    mapfile -t targets < <("$3" "$2")
    if bounded "$(left)" deploy/build.sh "$2" "${targets[@]}" >>"$log" 2>&1; then return 0; fi
  fi
  echo "nightly: $1: building failed: $log" >&2
  record "$1" - 1 $((SECONDS - began)) -
  return 1
}

# tests PART RUN PRESET SEED CTEST_OPTION...: leaves RUN.log and RUN.xml.
tests() {
  local part=$1 run=$2 preset=$3 seed=$4 status=0 began=$SECONDS
  shift 4
  [ "$(left)" -gt 0 ] || return 0
  bounded "$(left)" env ${seed:+PROSECTOR_SEED=$seed} ctest --test-dir "build/$preset" -j2 --output-on-failure \
    --output-junit "$out/$run.xml" --test-output-size-passed 1000000 --timeout 7200 "$@" >"$out/$run.log" 2>&1 || status=$?
  record "$part" "${seed:--}" $status $((SECONDS - began)) "$run.xml"
  [ $status -eq 0 ] ||
    echo "nightly: $part failed: $out/$run.log${seed:+; again: PROSECTOR_SEED=$seed ctest --test-dir build/$preset $*}" >&2
}

run_package() {
  build_for package release everything || return 0
  tests package package release "" -L '^package$'
}

run_learn() {
  local status=0 began=$SECONDS
  build_for learn release everything || return 0
  bounded "$(left)" deploy/learn.sh --out "$out/learn" >"$out/learn.log" 2>&1 || status=$?
  record learn - $status $((SECONDS - began)) -
  [ $status -eq 0 ] || echo "nightly: learn failed: $out/learn.log" >&2
}

# Each scene has its half hour, or, where less is left, its share of half of that: other parts need time, too.
run_mice() {
  build_for mice release everything || return 0
  local scenes=(deploy/scenes/*.toml) seconds=1800 scene name seed began status
  [ $((seconds * ${#scenes[@]} * 2)) -lt "$(left)" ] || seconds=$(($(left) / 2 / ${#scenes[@]}))
  for scene in "${scenes[@]}"; do
    status=0 began=$SECONDS name=$(basename "$scene" .toml) seed=$RANDOM
    bounded "$(left)" tests/e2e/mice.py build/release/bin "$out/mice-$name" "$scene" --seconds $seconds --seed $seed \
      >"$out/mice-$name.log" 2>&1 || status=$?
    record mice $seed $status $((SECONDS - began)) -
    [ $status -eq 0 ] || echo "nightly: mice failed in $name: $out/mice-$name.log" >&2
  done
}

run_asan() {
  build_for asan asan-full every_test || return 0
  # Terminals and processes that tests time are too slow then: drivers and server_process run optimised, in the gate.
  local filters=(-L '(unit|fuzz|image)$' -E '^(drivers|server_process)\.')
  deploy/left_out.py stay build/asan-full all -- "${filters[@]}" >"$out/asan.tests"
  tests asan asan asan-full "" -I "$out/asan.tests" "${filters[@]}"
}

run_tsan() {
  build_for tsan tsan threaded_tests || return 0
  export TSAN_OPTIONS="suppressions=$root/tests/tsan.supp:second_deadlock_stack=1"
  tests tsan tsan tsan "" -R "$threaded"
  unset TSAN_OPTIONS
}

# run_seeds SECONDS: rounds as long as one more fits, one at least.
run_seeds() {
  local until=$((SECONDS + $1)) round=0 longest=0 began seed preset presets=(release) filters
  build_for seeds release everything || return 0  # whole programs are among what the gate leaves out
  ! is_built asan-full || presets+=(asan-full)
  while [ $round -eq 0 ] || [ $((SECONDS + longest)) -lt $until ]; do
    round=$((round + 1)) began=$SECONDS
    seed=$(od -An -N4 -tu4 /dev/urandom | tr -d ' ')
    for preset in "${presets[@]}"; do
      # Sanitized builds have tests alone, no programs.
      filters=()
      [ "$preset" = release ] || filters=(-L '(unit|fuzz|image)$')
      echo "nightly: seeds: round $round, $preset, PROSECTOR_SEED=$seed"
      deploy/left_out.py rest "build/$preset" all -- "${filters[@]}" >"$out/seeds-$preset.tests"
      tests seeds "seeds-$round-$preset" "$preset" "$seed" -I "$out/seeds-$preset.tests" "${filters[@]}"
    done
    longest=$((SECONDS - began > longest ? SECONDS - began : longest))
  done
}

# run_play SECONDS
run_play() {
  local status=0 began=$SECONDS
  if [ ! -x deploy/play.sh ]; then
    echo "nightly: deploy/play.sh is missing; nothing played"
    return 0
  fi
  bounded "$(left)" deploy/play.sh --hours "$(awk -v s="$1" 'BEGIN { printf "%.3f", s / 3600 }')" >"$out/play.log" 2>&1 || status=$?
  record play - $status $((SECONDS - began)) -
  [ $status -eq 0 ] || echo "nightly: play failed: $out/play.log" >&2
}

echo "nightly: at most $hours h, to $out"
for part in "${chosen[@]}"; do
  [ "$(left)" -gt 0 ] || break
  case $part in
    package) run_package ;;
    learn) run_learn ;;
    mice) run_mice ;;
    asan) run_asan ;;
    tsan) run_tsan ;;
    seeds) if is_chosen play && [ -x deploy/play.sh ]; then run_seeds $(($(left) / 2)); else run_seeds "$(left)"; fi ;;
    play) run_play "$(left)" ;;
  esac
done
exec deploy/nightly_figures.py "$out" "${chosen[@]}"
