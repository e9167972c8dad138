#!/usr/bin/env bash
# Writes tests/ledger/hashes.txt anew, or the lines of the sessions named: for changes that mean to change results.
# The CHANGELOG then says which sessions replay differently, and why.
set -euo pipefail
cd "$(dirname "$0")/.."
case "${1:-}" in -h | --help) echo "usage: deploy/renew_ledger.sh [SESSION_NAMED_AS_ITS_TEST...]"; exit ;; esac
deploy/build.sh release test_ledger
[ $# -gt 0 ] || { set -- '*'; rm -f tests/ledger/hashes.txt; }
for session in "$@"; do
  PROSECTOR_RENEW_LEDGER=1 build/release/bin/test_ledger --gtest_filter="Sessions/Ledger.*/$session"
done
git diff --stat -- tests/ledger/hashes.txt
