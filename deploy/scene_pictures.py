#!/usr/bin/python3
"""Draws the shipped scenes for docs/look-up/rendering-figures.md, and sets them beside what an older commit had drawn.

deploy/scene_pictures.py [--client PROGRAM] [--out FOLDER] [--before COMMIT] [--only NAME...]
  --client  the client to draw with (default build/release/bin/prosector-client)
  --out     where the pictures go (default docs/pictures/scenes)
  --before  the commit whose pictures are the ones before (default 3143646^, before light from around)
  --only    draw no more than these, for instance abdomen.png glass.png before-after.png
"""
import argparse
import pathlib
import subprocess
import tempfile

from picture_files import below, beside, draw, part_of, read_png, root, rows_of, shrunk, write_png

sheets = ["abdomen", "choice", "cloth", "contact", "cut", "head", "minimal", "rigid", "ropes", "touch", "brain"]
singles = {  # file: scene and view
    "curves": ("curves", "scene"),
    "sheet_cut": ("sheet_cut", "scene"),
    "section-liver": ("cut", "section"),
    "section-head": ("head", "section"),
    "section-brain": ("brain", "section"),
}

# Scenes beside what they were, and which picture of their sheet: 0 from the scene's camera, 4 from close by.
compared = [
    ("abdomen", 0), ("abdomen", 4), ("head", 0), ("head", 4), ("cut", 0), ("cut", 4),
    ("touch", 0), ("touch", 4), ("minimal", 4), ("rigid", 0), ("ropes", 4), ("cloth", 4),
    ("choice", 4), ("contact", 4), ("curves", None), ("sheet_cut", None),
]  # fmt: skip
cell, border = (200, 150), 4  # of a contact sheet, pixels


def cell_of(rows, number):
    """Returns a picture of a contact sheet by its number; of a single picture all, as small."""
    if number is None:
        return shrunk(rows, *cell)
    columns = (len(rows[0]) // 3 - border) // (cell[0] + border)
    left, top = (border + k * (length + border) for k, length in zip((number % columns, number // columns), cell))
    return part_of(rows, (left, top, *cell), 1)


def before_after(out, commit):
    """Returns pairs of pictures, before at the left, two pairs a row."""
    pairs = []
    for scene, number in compared:
        name = f"docs/pictures/scenes/{scene}.png"
        old = subprocess.run(["git", "show", f"{commit}:{name}"], cwd=root, capture_output=True, check=True).stdout
        pairs.append(beside([cell_of(rows_of(old, name), number), cell_of(read_png(out / f"{scene}.png"), number)], 1))
    return below([beside(pairs[k : k + 2], 8) for k in range(0, len(pairs), 2)])


def sheet_of(client, folder, scene, *options):
    """Returns the contact sheet of a scene: of all views, if no options say otherwise."""
    command = [client, "render", root / f"deploy/scenes/{scene}.toml", "--out", folder, "--sheet", *options]
    subprocess.run([str(word) for word in command], check=True, capture_output=True)
    return read_png(pathlib.Path(folder) / f"{scene}-sheet.png")


def glass(client, folder):
    """Returns a ball and a dish of glass, and the same without refraction."""
    part = (110, 165, 578, 270)
    return beside(
        [part_of(draw(client, folder, "curves", "glass", *effect, size=(800, 600)), part, 1)
         for effect in ((), ("--effect", "refraction=off"))]
    )  # fmt: skip


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--client", default=root / "build/release/bin/prosector-client")
    options.add_argument("--out", type=pathlib.Path, default=root / "docs/pictures/scenes")
    options.add_argument("--before", default="3143646^")
    options.add_argument("--only", nargs="+")
    chosen = options.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        drawn = {f"{scene}.png": lambda scene=scene: sheet_of(chosen.client, folder, scene) for scene in sheets}
        for name, (scene, view) in singles.items():
            drawn[f"{name}.png"] = lambda scene=scene, view=view: draw(chosen.client, folder, scene, view)
        drawn["effects.png"] = lambda: sheet_of(chosen.client, folder, "cut", "--view", "close", "--compare")
        drawn["glass.png"] = lambda: glass(chosen.client, folder)
        drawn["shaft.png"] = lambda: draw(chosen.client, folder, "cut", "shaft", size=(400, 300))
        drawn["before-after.png"] = lambda: before_after(chosen.out, chosen.before)
        for name, picture in drawn.items():
            if not chosen.only or name in chosen.only:
                write_png(chosen.out / name, picture())
                print(name, flush=True)


if __name__ == "__main__":
    main()
