#!/usr/bin/python3
"""renew_pictures.py [--list] [--out DIR] [PRODUCER...]: renews docs/pictures with the programs of build/release/bin.

A producer is a command that leaves images in a folder; PRODUCERS says which image becomes which picture of docs/pictures.
Without a name all producers run, one after another, in about an hour. --list prints the producers and their pictures.
--out is the folder for the images of producers that are not tests (default out/pictures).
Plots of figures are not listed here: `prosector-bench SUBJECT --svg docs/pictures` draws them with the figures (PLOTS).
deploy/check_docs.py refuses a picture that nothing here produces.
"""

import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PICTURES = ROOT / "docs/pictures"
BUILD = ROOT / "build/release"
EDGE = 4  # pixels between images that stand side by side


def one(name):
    """The image of that name in the producer's folder, unchanged."""
    return lambda folder, target: shutil.copyfile(folder / name, target)


def grid(names, columns, size=None, edge=EDGE):
    """Images of one size in rows of so many columns. size: of each in the picture, pixels; edge: pixels between them."""

    def make(folder, target):
        from PIL import Image  # here, since deploy/check_docs.py reads the tables of this file without python3-pil

        cells = [Image.open(folder / name).convert("RGB") for name in names]
        cells = [image.resize(size, Image.LANCZOS) if size else image for image in cells]
        width, height = cells[0].size
        rows = -(-len(cells) // columns)
        sheet = Image.new("RGB", (columns * (width + edge) - edge, rows * (height + edge) - edge), "white")
        for k, cell in enumerate(cells):
            sheet.paste(cell, (k % columns * (width + edge), k // columns * (height + edge)))
        sheet.save(target)

    return make


def film(name, width, height, rate):
    """An animated picture of a film."""

    def make(folder, target):
        command = [ROOT / "deploy/animated_picture.py", folder / name, target, width, height, rate]
        subprocess.run([str(part) for part in command], check=True)

    return make


def same_names(names, folder="."):
    """Pictures that have the names of their images."""
    return {name: one(f"{folder}/{name}") for name in names}



def test(name, folder, pictures):
    """An end-to-end test, whose images are in its folder of the build."""
    return ["ctest", "--test-dir", str(BUILD), "-R", f"^{re.escape(name)}$", "--output-on-failure"], pictures, BUILD / "tests/e2e" / folder


def unit(program, tests, pictures):
    """A unit test that keeps what it drew in the folder PROSECTOR_PICTURES."""
    return [str(BUILD / "bin" / program), f"--gtest_filter={tests}"], pictures


def observed(scene, seconds, *options):
    """A picture that an observer of a scene takes after so many seconds."""
    return [str(ROOT / "deploy/observe_scene.sh"), scene, "{out}/picture.png", str(seconds), *options]


LESSONS = {
    "desk": ("above", "cut", "first", "help", "holds", "touched"), "headset": ("outside", "stereo"), "host": ("guest", "stopped", "window"),
    "observer": ("eyes", "names", "strain", "window"), "researcher": ("trade",), "webcam": ("outside", "through"),
}  # fmt: skip
EFFECTS = ("ambient_occlusion", "dispersion", "edges", "film", "parallax", "reflections", "refraction", "relief", "shadows", "shafts", "translucency")
SCENES = ("abdomen", "before-after", "brain", "choice", "cloth", "contact", "curves", "cut", "effects", "glass", "head", "minimal", "rigid", "ropes",
          "section-brain", "section-head", "section-liver", "shaft", "sheet_cut", "touch")  # fmt: skip

# Name: command, {picture: how it is made of the images}, and the folder of the images where it is not {out}.
PRODUCERS = {
    **{f"learn-{lesson}": (["{root}/deploy/learn.sh", "--out", "{out}", lesson], same_names([f"learn-{lesson}-{name}.png" for name in names], "pictures"))
       for lesson, names in LESSONS.items()},
    "demo": (["{root}/deploy/demo.sh", "--headless", "--seconds", "20", "--no-film", "--skip-setup", "--out", "{out}"], same_names(["headset.png"])),
    "demo_cut": (["{root}/deploy/demo_cut.sh", "--size", "480x360", "--skip-setup", "--out", "{out}"], same_names(["cut-first.png", "cut-liver.png"])),
    "demo_sheet": (["{root}/deploy/demo_sheet.sh", "--skip-setup", "--out", "{out}"], {"cut-sheet.png": one("late-cut.png")}),
    "demo_film": (["{root}/deploy/demo_film.sh", "--skip-setup", "--out", "{out}"],
                  {"film.png": one("cut.png"), "film.webp": film("film.avi", 640, 360, 6)}),
    "demo_panel": (["{root}/deploy/demo_panel.sh", "--skip-setup", "--out", "{out}"],
                   {"panel.png": one("eyes-slider.png"), "panel-observer.png": one("slider.png")}),
    "demo_parts": (["{root}/deploy/demo_parts.sh", "--skip-setup", "--out", "{out}"],
                   {f"parts-{name}.png": one(f"{name}.png") for name in ("labelled", "searched", "isolated")}),
    "demo_touch": (["{root}/deploy/demo_touch.sh", "--skip-setup", "--out", "{out}"],
                   {f"touch-{name}.png": one(f"{name}.png") for name in ("together", "button", "slider")}),
    "see_through": (["{root}/deploy/see_through_video.py", "{root}/build/release/bin", "{out}", "{out}/see-through.webp"],
                    same_names(["see-through.webp"])),
    "cloth": (observed("cloth", 8, "--size", "1200x560"), {"cloth.png": one("picture.png")}),
    "ropes": (observed("ropes", 4, "--size", "1000x600"), {"ropes.png": one("picture.png")}),
    "residual": (observed("cloth", 2, "--size", "640x480", "--color-by", "residual"), {"scenes/residual.png": one("picture.png")}),
    "strain": (observed("choice", 6, "--size", "640x480", "--color-by", "strain"), {"scenes/strain.png": one("picture.png")}),
    "effects": (["{root}/deploy/effect_pictures.py", "--out", "{out}"], {f"scenes/effect-{name}.png": one(f"effect-{name}.png") for name in EFFECTS}),
    "scenes": (["{root}/deploy/scene_pictures.py", "--out", "{out}"], {f"scenes/{name}.png": one(f"{name}.png") for name in SCENES}),
    "setup_window": test("e2e.setup_window", "setup_window", same_names(["setup-enter.png"])),
    "setup_devices": test("e2e.setup_devices", "setup_devices", same_names([f"setup-{name}.png" for name in ("devices", "checks", "tracker", "glove")])),
    "setup_calibrate": test("e2e.setup_calibrate", "setup_calibrate", same_names(["setup-calibrate.png"])),
    "setup_face": test("e2e.setup_face", "setup_face", same_names(["setup-window.png"])),
    "setup_field": unit("test_setup", "Pages.LeadThroughABentField*", {"setup-field.png": one("field.png")}),
    "setup_eyes": unit("test_setup", "Pages.TheRulerFindsHowFarEyesAreApart*", {"setup-pictures.png": one("ruler.png")}),
    "setup_camera": unit("test_camera_page", "CameraPage.FindsALens*", {"setup-camera.png": one("camera-guide-1x.png")}),
    "desk_cut": test("e2e.desk_cut", "desk_cut", {"cut-drawn.png": one("sheet.png")}),
    "openxr": test("e2e.openxr.hands", "openxr_hands", {"headset-openxr.png": grid(["left.ppm", "right.ppm"], 2)}),
    "tablet": test("e2e.tablet_liver", "tablet_liver", {"tablet.png": grid(
        [f"{who}_{what}.png" for what in ("press", "button") for who in ("holder", "observer")], 2, size=(400, 300), edge=0)}),
    "phantom": test("e2e.ar", "ar", {"phantom.png": grid(["holder_0.png", "bare_0.png"], 2, size=(400, 300))}),
}  # fmt: skip

PLOTS = {
    "trade": [f"trade-{case}.svg" for case in
              ("bend", "bend_incompressible", "cube", "free", "hang", "heavy", "organ", "press", "slab", "swing")],
    "stability": ["stability.svg"], "collision": ["collision.svg"], "contact": ["contact-hertz.svg"], "estimate": ["estimate.svg"],
    "refine": [f"refine-{body}.svg" for body in ("layer", "liver", "organ")], "camera": ["camera-distance.svg", "camera-speed.svg"],
    "haptics": ["haptics-felt.svg", "haptics-stable.svg"],
}  # fmt: skip


def listed():
    """The paths below docs/pictures of all pictures that something produces."""
    return {name for _, pictures, *_ in PRODUCERS.values() for name in pictures} | {name for names in PLOTS.values() for name in names}


def renew(name, out):
    """Runs a producer and replaces its pictures. Returns what went wrong; None: nothing."""
    command, pictures, *own = PRODUCERS[name]
    folder = own[0] if own else out / name
    folder.mkdir(parents=True, exist_ok=True)
    words = [word.format(root=ROOT, out=folder) for word in command]
    done = subprocess.run(words, env={**os.environ, "PROSECTOR_PICTURES": str(folder)}, capture_output=True, text=True)
    if done.returncode != 0:
        return f"{' '.join(words)} ended with status {done.returncode}\n" + "\n".join((done.stdout + done.stderr).splitlines()[-20:])
    try:
        for picture, make in pictures.items():
            make(folder, PICTURES / picture)
    except OSError as error:
        return f"{picture}: {error}"
    return None


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--list", action="store_true")
    options.add_argument("--out", type=pathlib.Path, default=ROOT / "out/pictures")
    options.add_argument("producers", nargs="*", metavar="PRODUCER", help=", ".join(PRODUCERS))
    chosen = options.parse_args()
    if unknown := set(chosen.producers) - set(PRODUCERS):
        options.error(f"unknown producer {', '.join(sorted(unknown))}; producers: {', '.join(PRODUCERS)}")
    failed = []
    for name in chosen.producers or PRODUCERS:
        if chosen.list:
            print(f"{name}: {', '.join(PRODUCERS[name][1])}")
        elif wrong := renew(name, chosen.out):
            failed.append(name)
            print(f"{name}: FAILED: {wrong}", flush=True)
        else:
            print(f"{name}: renewed {', '.join(PRODUCERS[name][1])}", flush=True)
    if failed:
        sys.exit(f"renew_pictures: {len(failed)} producers failed: {', '.join(failed)}")


if __name__ == "__main__":
    main()
