#!/usr/bin/python3
"""Draws each effect on and off, side by side, for docs/look-up/rendering-figures.md.

deploy/effect_pictures.py [--client PROGRAM] [--out FOLDER]
  --client  the client to draw with (default build/release/bin/prosector-client)
  --out     where effect-*.png go (default docs/pictures/scenes)
"""
import argparse
import pathlib
import tempfile

from picture_files import beside, draw, part_of, root, write_png

# Effect, scene, view, its state in the right picture, size, part that is shown (left, top, width, height), enlarged.
pictures = [
    ("relief", "abdomen", "close", "off", (400, 300), (0, 0, 400, 300), 1),
    ("film", "abdomen", "close", "off", (400, 300), (0, 0, 400, 300), 1),
    ("translucency", "abdomen", "close", "off", (400, 300), (0, 0, 400, 300), 1),
    ("reflections", "abdomen", "scene", "off", (400, 300), (0, 0, 400, 300), 1),
    ("parallax", "abdomen", "scene", "off", (800, 600), (300, 420, 200, 150), 2),
    ("shafts", "cut", "scene", "off", (400, 300), (0, 0, 400, 300), 1),
    ("refraction", "curves", "glass", "off", (400, 300), (0, 0, 400, 300), 1),
    ("dispersion", "curves", "glass", "off", (800, 600), (140, 310, 133, 100), 3),
    ("shadows", "rigid", "scene", "off", (400, 300), (0, 0, 400, 300), 1),
    ("edges", "ropes", "scene", "off", (400, 300), (130, 100, 133, 100), 3),
    ("ambient_occlusion", "abdomen", "close", "off", (400, 300), (0, 0, 400, 300), 1),
]


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--client", default=root / "build/release/bin/prosector-client")
    options.add_argument("--out", type=pathlib.Path, default=root / "docs/pictures/scenes")
    chosen = options.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        for effect, scene, view, other, size, part, times in pictures:
            both = [
                part_of(
                    draw(chosen.client, folder, scene, view, "--quality", "medium", "--effect", f"{effect}={state}", size=size),
                    part,
                    times,
                )
                for state in ("on", other)
            ]
            write_png(chosen.out / f"effect-{effect}.png", beside(both))
            print(f"effect-{effect}.png", flush=True)


if __name__ == "__main__":
    main()
