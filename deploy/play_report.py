#!/usr/bin/python3
"""play_report.py DIR: sums what deploy/play.sh left in DIR into figures.json and table.md, and prints the table.

Exits with 1 where a bout ended with an organ out of bounds, a saved state could not be restored, or a run ended by itself.
"""
import json
import pathlib
import re
import sys

if len(sys.argv) != 2:
    sys.exit(__doc__)
folder = pathlib.Path(sys.argv[1])
runs = [run for file in sorted(folder.glob("[0-9]*.json")) for run in json.loads(file.read_text())["runs"]]
ended = [line for log in sorted(folder.glob("*.log")) for line in log.read_text().splitlines()
         if re.match(r"play: exit", line)]


def worst(rows):
    return {
        "seconds": sum(r["seconds"] for r in rows),
        "bouts": sum(r["bouts"] for r in rows),
        "acts": sum(r["acts"] for r in rows),
        "bad": sum(r["bad"] for r in rows),
        "least_volume": min(r["least_volume"] for r in rows),
        "most_volume": max(r["most_volume"] for r in rows),
        "overlap_mm": max(r["overlap_mm"] for r in rows),
        "recovery_s": max(r["recovery_s"] for r in rows),
        "resets": sum(r["resets"] for r in rows),
        "bad_saves": sum(r["bad_saves"] for r in rows),
    }


if not runs:
    sys.exit("play: nothing was played")
table = {scene: worst([r for r in runs if r["scene"] == scene]) for scene in sorted({r["scene"] for r in runs})}
table["all"] = worst(runs)
found = [line for run in runs for line in run["found"]]
(folder / "figures.json").write_text(json.dumps({"scenes": table, "found": found, "ended": ended}, indent=1))
lines = ["| scene | simulated s | bouts | acts | out of bounds | least volume | most volume | worst overlap, mm | longest recovery, s | resets | states that can't be restored |",
         "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |"]
for scene, row in table.items():
    lines.append(f"| {scene} | {row['seconds']:.0f} | {row['bouts']} | {row['acts']} | {row['bad']} | {row['least_volume']:.3f} | "
                 f"{row['most_volume']:.3f} | {row['overlap_mm']:.2f} | {row['recovery_s']:.2f} | {row['resets']} | {row['bad_saves']} |")
(folder / "table.md").write_text("\n".join(lines) + "\n")
print("\n".join(lines + found + ended))
sys.exit(1 if found or ended else 0)
