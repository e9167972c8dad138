#!/usr/bin/python3
"""openxr_watched_test.py BIN OUT egl|glx, run under deploy/with_display.sh: others watch what a headset's left eye sees in a window on the desk, and it is
recorded. The runtime is our double, which takes pictures by EGL or by GLX. Once they close the window the session goes on."""
import io
import os
import pathlib
import signal
import struct
import sys
import time

from PIL import Image, ImageChops, ImageFilter, ImageGrab, ImageStat

from checks import check, figures, finish
from desk_person import act, geometry, wait_until, window_of, windows
from program import Program

HERE = pathlib.Path(__file__).parent
BIN, OUT, BY = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3]
WIDTH, HEIGHT = 300, 320  # pixels of an eye's picture
OUT.mkdir(parents=True, exist_ok=True)
for old in OUT.glob("*"):
    old.unlink()


def left_eye():
    """What the left eye sees, as the runtime got it; None while it is being written."""
    try:
        return Image.open(OUT / "left.ppm").convert("RGB")
    except OSError:
        return None


def compare(what, image):
    """Checks that the image is the left eye's but for its size and coding, and not the right eye's."""
    off = []
    for eye in ("left", "right"):
        shown = Image.open(OUT / f"{eye}.ppm").convert("RGB").resize(image.size, Image.BILINEAR).filter(ImageFilter.GaussianBlur(2))
        off.append(sum(ImageStat.Stat(ImageChops.difference(shown, image.filter(ImageFilter.GaussianBlur(2)))).mean) / 3)
    print(f"{what}: off by {off[0]:.2f} of 255 from the left eye's picture, by {off[1]:.2f} from the right eye's")
    check(what, off[0] < 4 and off[1] > 2 * off[0])


session = f"watched{os.getpid()}"
env = {"XR_RUNTIME_JSON": str(BIN.parent / "lib/twins/openxr_double.json"),
       "PROSECTOR_OPENXR": f"--waits-for {OUT}/go --script {HERE / 'openxr_wearer.csv'} --pictures {OUT} --width {WIDTH} --height {HEIGHT}"
       + (" --glx" if BY == "glx" else "")}
programs = []
try:
    programs.append(Program(BIN / "prosector-server", HERE.parents[1] / "deploy/scenes/minimal.toml", "--session", session))
    programs[0].wait("is open")
    user = Program(BIN / "prosector-client", "join", "--name", "Wearer", "--display", "openxr", "--session", session, "--no-overlay", "--spectator-window",
                   "--record", OUT / "left.avi", "--summary", OUT / "client.json", env=env)
    programs.append(user)
    user.wait("everything is here")
    window = window_of(user.process, "Prosector: audience", "the audience's window")
    check("it is a window, and fills no monitor", geometry(window)[2:] == (800, 600))
    act("windowsize", "--sync", window, 700, HEIGHT, "windowmove", "--sync", window, 40, 30)
    wait_until("a picture for the left eye", left_eye)
    time.sleep(1.5)
    seen = ImageGrab.grab(xdisplay="").crop((40, 30, 740, 30 + HEIGHT))
    seen.save(OUT / "window.png")
    bar = (700 - WIDTH) // 2
    compare("the window shows what the left eye sees", seen.crop((bar, 0, bar + WIDTH, HEIGHT)))
    check("beside it the window is black", seen.crop((0, 0, bar - 2, HEIGHT)).getextrema() == ((0, 0),) * 3)
    (OUT / "go").touch()
    act("windowfocus", "--sync", window, "key", "Escape")
    wait_until("the window's end", lambda: not windows("Prosector: audience"))
    written = (OUT / "left.ppm").stat().st_mtime
    wait_until("pictures after the window's end", lambda: (OUT / "left.ppm").stat().st_mtime > written + 0.2)
    user.wait("you hold the ball")
    user.end(signal.SIGINT)
    check("the client ends well", user.process.returncode == 0)
    renderer = figures(OUT / "client.json")["renderer"]
    check(f"it was drawn by {renderer}", renderer.startswith(f"{BY.upper()} with a window"))
    video = (OUT / "left.avi").read_bytes()
    frames, = struct.unpack("<I", video[48:52])  # of the main header of AVI
    check(f"the video is as large as an eye's picture, and has {frames} frames", struct.unpack("<2I", video[64:72]) == (WIDTH, HEIGHT) and frames > 30)
    end = video.rindex(b"\xff\xd9")
    compare("its last frame is what the left eye saw", Image.open(io.BytesIO(video[video.rindex(b"\xff\xd8\xff", 0, end):end + 2])).convert("RGB"))
    check("the client keeps to the specification", not any("simulated OpenXR: error:" in line for line in user.lines))
finally:
    for program in programs:
        program.end(signal.SIGINT)
finish()
