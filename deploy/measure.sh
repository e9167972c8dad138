#!/usr/bin/env bash
# Runs prosector-bench, keeps its reports and plots, and fills the tables of docs/ from them.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
subjects=(trade stability scaling soft integrators beam beam101k press collision contact references refine)

usage() {
  cat <<TXT
deploy/measure.sh [--quick] [--out DIR] [--skip-build] [SUBJECT...]
  SUBJECT        of: ${subjects[*]} (default: all, an hour or more)
  --quick        coarser and shorter: checks that everything runs; not for publication
  --out DIR      output folder for reports (default out/measure); plots go to docs/pictures
  --skip-build   don't build (PROSECTOR_BIN: folder of the programs; default build/release/bin)
TXT
}

quick=no out=$root/out/measure build=yes chosen=()
while [ $# -gt 0 ]; do
  case "$1" in
    --quick) quick=yes ;;
    --out) out=${2:?--out needs a folder}; shift ;;
    --skip-build) build=no ;;
    -h | --help) usage; exit 0 ;;
    *)
      case " ${subjects[*]} " in
        *" $1 "*) chosen+=("$1") ;;
        *) echo "measure: $1 is not an option or a subject" >&2; usage >&2; exit 2 ;;
      esac ;;
  esac
  shift
done
[ ${#chosen[@]} -gt 0 ] || chosen=("${subjects[@]}")

[ $build = no ] || "$root/deploy/build.sh" release prosector-bench
bin=${PROSECTOR_BIN:-$root/build/release/bin}
pictures=$root/docs/pictures
[ $quick = no ] || pictures=$out
mkdir -p "$out"

arguments() {  # of a subject, as published or quick
  case "$1 $quick" in
    'trade no') echo --svg "$pictures" ;;
    'trade yes') echo --quick --limit 200 --svg "$pictures" ;;
    'stability no') echo --svg "$pictures" ;;
    'stability yes') echo --quick --svg "$pictures" ;;
    'scaling yes') echo --max 1000 ;;
    'soft no') echo --tets 4000 --repeats 61 ;;
    'soft yes') echo --tets 600 --repeats 5 ;;
    'beam yes') echo --cells 2 3 ;;
    'beam101k yes') echo --steps 5 ;;
    'press yes') echo --cells 6 ;;
    'collision no') echo --svg "$pictures" ;;
    'collision yes') echo --pairs 50 --bodies 300 --triangles 2048 --svg "$pictures" ;;
    'references yes') echo --quick ;;
    'refine no') echo --svg "$pictures" ;;
    'refine yes') echo --quick --svg "$pictures" ;;
    'contact no') echo --svg "$pictures" ;;
    'contact yes') echo --quick ;;
  esac
}

for subject in "${chosen[@]}"; do
  printf '\n== %s (%d min %02d s)\n' "$subject" $((SECONDS / 60)) $((SECONDS % 60))
  # shellcheck disable=SC2046  # words, on purpose
  "$bin/prosector-bench" "$subject" $(arguments "$subject") --json "$out/$subject.json"
done

if [ $quick = yes ]; then
  printf '\nReports and plots: %s; the tables in docs/ are unchanged\n' "$out"
else
  "$root/deploy/fill_tables.py" "$out"
fi
