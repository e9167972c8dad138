#!/usr/bin/python3
"""Checks what the demo left in DIR: every figure there, the liver pressed and back, pictures that differ, a video."""

import json
import pathlib
import sys

FIGURES = """scene tets participants observers real_time_factor step_ms_p50 step_ms_p99 device_to_observer_ms_p50
device_to_observer_ms_p99 late_join_ms observer_kbit_s invalid_dropped max_liver_displacement_mm state_hash""".split()

folder = pathlib.Path(sys.argv[1])
summary = json.loads((folder / "summary.json").read_text())
failures = []


def check(what, holds):
    print(("ok    " if holds else "FAILED"), what)
    if not holds:
        failures.append(what)


for figure in FIGURES:
    check(f"{figure} = {summary.get(figure)}", summary.get(figure) is not None)
check("at least 3,000 tetrahedra", summary["tets"] >= 3000)
camera = folder / "camera.json"
check("everybody took part, and an observer watched", summary["participants"] == (2 if camera.exists() else 1) and summary["observers"] == 1)
check("the liver gave way by at least 10 mm", summary["max_liver_displacement_mm"] >= 10)
check("and came back within 1 mm of rest", summary["residual_displacement_mm"]["liver"] <= 1)
check("the observer was complete within 2 s", summary["late_join_ms"] <= 2000)
check("latency stands on at least 300 records", summary["device_to_observer_samples"] >= 300)
check("nothing that arrived was invalid", summary["invalid_dropped"] == 0)
press = summary["pressed"]["liver"]
if "reference" in press:
    told, off = press["error"], press["off_reference"]
    check(f"the force is off the reference by {off:.0%}, and {told:.0%} was told", 0.5 * off <= told <= 2 * off)
else:
    print("skipped: the press has no reference: the CT liver is not fetched, or the scene is another one")
headset = json.loads((folder / "headset.json").read_text())
check("headset user and observer hold the same topology", headset["topology_hash"] == summary["topology_hash"])
if camera.exists():
    check("camera user and observer, too", json.loads(camera.read_text())["topology_hash"] == summary["topology_hash"])
    check(f"the observer saw the bare hand of {summary['camera_to_observer_samples']} pictures", summary["camera_to_observer_samples"] >= 20)
    check(f"{summary['camera_to_observer_ms_p50']} ms late", 0 < (summary["camera_to_observer_ms_p50"] or 0) < 1000)
else:
    print("skipped: the networks that find bare hands aren't fetched, so there was no camera user")

pictures = {name: (folder / f"{name}.png").read_bytes() for name in ("before", "press", "after", "headset")}
for name, data in pictures.items():
    check(f"{name}.png is a picture", data[:8] == b"\x89PNG\r\n\x1a\n" and len(data) > 20_000)
check("the pictures differ", len(set(pictures.values())) == len(pictures))
check("session.avi is a video", (folder / "session.avi").stat().st_size > 100_000)
sys.exit(1 if failures else 0)
