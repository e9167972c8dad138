#!/usr/bin/python3
"""nightly_figures.py OUT PART...: makes OUT/figures.json and OUT/table.md of OUT/runs.tsv and the JUnit files beside it.

Exits 1 where a run failed, or a part did not run.
"""
import datetime
import json
import pathlib
import subprocess
import sys

import junit


def count(report):
    if not report.is_file():
        return {"tests": 0, "failed": [], "skipped": 0}
    cases = junit.cases_of(report)
    return {"tests": len(cases), "failed": [junit.name(case) for case in cases if junit.failed(case)],
            "skipped": sum(len(junit.skipped(case)) for case in cases)}


def figures_of(part, out, lines):
    runs = [line.split("\t") for line in lines if line.split("\t")[0] == part]
    counts = [count(out / report) for *_, report in runs]
    failed = [{"seed": seed, "status": int(status), "tests": told["failed"]}
              for (_, seed, status, _, _), told in zip(runs, counts) if status != "0"]
    return {"part": part, "runs": len(runs), "tests": sum(told["tests"] for told in counts),
            "skipped": sum(told["skipped"] for told in counts), "failed": failed,
            "minutes": round(sum(int(seconds) for *_, seconds, _ in runs) / 60, 1)}


def row(figures):
    told = "; ".join(f"seed {one['seed']}: {', '.join(one['tests']) or 'status ' + str(one['status'])}" for one in figures["failed"])
    state = told or ("none" if figures["runs"] else "did not run")
    return f"| {figures['part']} | {figures['runs']} | {figures['tests']} | {figures['skipped']} | {state} | {figures['minutes']} |"


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    out = pathlib.Path(sys.argv[1])
    log = out / "runs.tsv"
    lines = log.read_text().splitlines() if log.is_file() else []
    parts = [figures_of(part, out, lines) for part in sys.argv[2:]]
    commit = subprocess.run(["git", "describe", "--always", "--dirty"], capture_output=True, text=True).stdout.strip()
    at = datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%dT%H:%M:%SZ")
    table = ["| part | runs | tests run | skipped | failed | minutes |", "| --- | --- | --- | --- | --- | --- |",
             *map(row, parts)]
    (out / "figures.json").write_text(json.dumps({"at": at, "commit": commit, "parts": parts}, indent=2) + "\n")
    (out / "table.md").write_text(f"At {at}, commit {commit}:\n\n" + "\n".join(table) + "\n")
    print((out / "table.md").read_text(), end="")
    sys.exit(any(part["failed"] or not part["runs"] for part in parts))


main()
