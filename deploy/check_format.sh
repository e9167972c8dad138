#!/usr/bin/env bash
# Our own C++ is laid out by .clang-format.
set -euo pipefail
cd "$(dirname "$0")/.."

if ! git ls-files -z '*.cpp' '*.h' | xargs -0 -r clang-format --dry-run -Werror; then
  echo "format: fix it with: git ls-files '*.cpp' '*.h' | xargs clang-format -i" >&2
  exit 1
fi
echo "format: good"
