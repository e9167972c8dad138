#!/usr/bin/python3
"""check_picture.py PICTURE FIGURES: an observer saw the red ball of minimal.toml, and missed nothing."""
import json
import sys

from PIL import Image

picture = Image.open(sys.argv[1]).convert("RGB")
pixels = list(picture.getdata())
red = sum(r > 100 and r > 1.4 * max(g, b) for r, g, b in pixels) / len(pixels)
print(f"{picture.size[0]}x{picture.size[1]}, {len(set(pixels))} colours, {100 * red:.1f} % red")
if not (0.01 < red < 0.5 and len(set(pixels)) > 500):
    sys.exit("that is no picture of a red ball on a table")
figures = json.load(open(sys.argv[2]))
print("late join", figures["late_join_ms"], "ms")
if figures["late_join_ms"] is None or figures["invalid_dropped"] or figures["contradictions"]:
    sys.exit(f"the observer missed something: {figures}")
