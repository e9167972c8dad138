#!/usr/bin/env bash
# Lets people play at random in the shipped scenes, under every model, and judges the organs when they have left.
# docs/do/play.md says what is judged and how to read what it leaves. Ends with 1 where an organ was out of bounds.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)

usage() { echo "usage: deploy/play.sh [--hours N] [--jobs N] [--seed N] [--out DIR] [SCENE...]"; }
refuse() { echo "play: $1" >&2; usage >&2; exit 2; }

hours=1 jobs=$(nproc) seed=$((RANDOM * 32768 + RANDOM)) out=$root/out/play scenes=()
while [ $# -gt 0 ]; do
  case "$1" in
    --hours) hours=${2:-}; shift ;;
    --jobs) jobs=${2:-}; shift ;;
    --seed) seed=${2:-}; shift ;;
    --out) out=${2:?--out needs a folder}; shift ;;
    -h | --help) usage; exit 0 ;;
    -*) refuse "$1 is no option" ;;
    *) scenes+=("$1") ;;
  esac
  shift
done
[[ $hours =~ ^[0-9]+(\.[0-9]+)?$ ]] || refuse "--hours $hours: expected a number of hours, such as 8 or 0.5"
[[ $jobs =~ ^[1-9][0-9]*$ ]] || refuse "--jobs $jobs: expected a number of runs at once"
[[ $seed =~ ^[0-9]+$ ]] || refuse "--seed $seed: expected a whole number"
shipped=no
[ ${#scenes[@]} -gt 0 ] || shipped=yes
[ $shipped = no ] || scenes=("$root"/deploy/scenes/{touch,abdomen,cut,head,minimal,contact,curves,sheet_cut}.toml)
# As the scene says, then each model instead.
models=("" fem_neo_hookean mass_spring fem_stvk fem_linear fem_neo_hookean_polynomial fem_fibers xpbd)

"$root/deploy/build.sh" release prosector-play
mkdir -p "$out"
# The 116 regions of the brain, too, where fetch_anatomy.sh has been.
atlas=${PROSECTOR_DATA:-${XDG_DATA_HOME:-$HOME/.local/share}/prosector}/aal.nii.gz
if [ $shipped = yes ]; then
  if [ -f "$atlas" ]; then
    scenes+=("$root/deploy/scenes/brain.toml")
  else
    echo "play: skipped: the brain: no $atlas (deploy/fetch_anatomy.sh)"
  fi
fi
rm -f "$out"/*.json "$out"/*.log
end=$((SECONDS + $(awk -v h="$hours" 'BEGIN { printf "%d", 3600 * h }')))
echo "play: seeds from $seed on, for $hours h"

# play_one NUMBER SCENE MODEL: some bouts of one seed.
play_one() {
  local options=(--seed "$1" --bouts 4 --saves --json "$out/$1.json")
  [ -z "$3" ] || options+=(--model "$3")
  timeout 1200 "$root/build/release/bin/prosector-play" "$2" "${options[@]}" >"$out/$1.log" 2>&1 || {
    local status=$?
    [ $status -eq 1 ] || echo "play: exit $status of: prosector-play $2 ${options[*]}" | tee -a "$out/$1.log"
    return 0
  }
}

number=$seed
while [ $SECONDS -lt $end ]; do
  for model in "${models[@]}"; do
    for scene in "${scenes[@]}"; do
      [ $SECONDS -lt $end ] || break 2
      while [ "$(jobs -rp | wc -l)" -ge "$jobs" ]; do wait -n; done
      play_one $number "$scene" "$model" &
      number=$((number + 1))
    done
  done
done
wait
exec "$root/deploy/play_report.py" "$out"
