#!/usr/bin/python3
"""monado_test.py BIN OUT RUNTIME [SERVICE]: a client with a headset through a real OpenXR runtime, Monado. RUNTIME: its manifest; SERVICE:
monado-service, where RUNTIME needs that. In turn: its simulated headset, which sways; the devices of its `remote` driver, whose wearer looks
at a soft ball, presses and holds it, and opens a panel, until the service is killed and comes back; and what its compositor shows."""
import json
import math
import os
import pathlib
import shutil
import signal
import socket
import sys
import tempfile
import time

from PIL import Image, ImageGrab

from checks import check, figures, finish
from monado_wearer import MonadoWearer
from openxr_eyes import FOV, HEAD, look
from program import Program

HERE = pathlib.Path(__file__).parent
BIN, OUT, RUNTIME = map(pathlib.Path, sys.argv[1:4])
SERVICE = sys.argv[4:5]
ACROSS, UPWARDS = math.radians(42.5), math.atan(math.tan(math.radians(42.5)) * 70 / 65)  # from the middle of a display of 65 × 70 mm an eye
DISPLAY = {eye: (-ACROSS, ACROSS, UPWARDS, -UPWARDS, FOV[eye][4]) for eye in FOV}  # of Monado's remote headset, whatever it asks us to draw
BESIDE = (0, 0.965, 0.09)  # a right wrist from where the fingers reach into the ball

shutil.rmtree(OUT, ignore_errors=True)
OUT.mkdir(parents=True)
# The ball is anatomy, so that it has a panel.
SCENE = OUT / "scene.toml"
SCENE.write_text((HERE.parents[1] / "deploy/scenes/minimal.toml").read_text().replace('labels = "labels.csv"\n', "")
                 .replace('shape = "ball"\n', 'shape = "ball"\nanatomy = true\n'))
programs = []


def start(*words, **more):
    programs.append(Program(*words, **more))
    return programs[-1]


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def halves(both):
    half = both.width // 2
    return {"left": both.crop((0, 0, half, both.height)), "right": both.crop((half, 0, 2 * half, both.height))}


class Run:
    """A client in a session of its own; `env`: what its runtime is told."""

    def __init__(self, name, folder, env):
        self.name, self.folder = name, folder
        self.env = {"XDG_RUNTIME_DIR": str(folder), "XDG_CONFIG_HOME": str(folder), "XR_RUNTIME_JSON": str(RUNTIME), **env}
        self.session = f"monado{name}{os.getpid()}"
        self.log = OUT / f"{name}.jsonl"
        start(BIN / "prosector-server", SCENE, "--session", self.session).wait("is open")
        self.serve()
        self.user = start(BIN / "prosector-client", "join", "--name", "Wearer", "--display", "openxr", "--session", self.session, "--no-overlay",
                          "--summary", OUT / f"{name}.json", "--session-log", self.log, env=self.env)
        self.user.wait("headset: Monado")
        self.user.wait("everything is here")

    def serve(self):
        """Starts Monado's service, where its runtime is a process of its own."""
        line = self.folder / "monado_comp_ipc"
        line.unlink(missing_ok=True)  # of one that was killed
        self.service = start(*SERVICE, env=self.env) if SERVICE else None
        end = time.monotonic() + 10
        while SERVICE and not line.exists() and time.monotonic() < end:
            time.sleep(0.05)

    def told(self):
        """What the server says, over time."""
        out = []
        for line in open(self.log):
            try:
                out.append(json.loads(line))
            except json.JSONDecodeError:
                break
        return out

    def wearer(self):
        return self.told()[-1]["people"].get("Wearer", {})

    def wait_for(self, what, holds, seconds=20):
        end = time.monotonic() + seconds
        while not holds(self.wearer()):
            if time.monotonic() > end:
                print(f"the wearer now: {self.wearer()}")
                return check(what, False)
            time.sleep(0.1)
        check(what, True)

    def ball(self):
        return self.told()[-1]["parts"]["ball"]

    def press_menu(self, hand, what, there):
        """Presses the menu's button of the hand's controller, which is to open a panel or to close it."""
        hand.menu = True
        self.wait_for(f"a controller's button {what} the panel, though the hand is of joints", lambda _: bool(self.told()[-1]["panels"]) == there)
        hand.menu = False
        time.sleep(0.3)

    def picture(self, file):
        """Both eyes' picture now, by eye."""
        self.user.say(f"picture {OUT / file}")
        end = time.monotonic() + 10
        while not (OUT / file).exists() and time.monotonic() < end:
            time.sleep(0.1)
        time.sleep(0.3)
        return halves(Image.open(OUT / file).convert("RGB"))

    def end(self, frames, in_time):
        """Ends the client, which had so many frames at least; `in_time`: the least share that kept the runtime's rhythm."""
        self.user.end(signal.SIGINT)
        check(f"{self.name}: the client ends well", self.user.process.returncode == 0)
        pace = figures(OUT / f"{self.name}.json")["headset"]
        print(f"{self.name}: {pace['frames']} frames, {pace['period_ms']:.2f} ms apart as told, {pace['interval_ms']:.2f} ms on average, "
              f"{pace['longest_interval_ms']:.1f} ms at most; {pace['in_time']} in time, {pace['missed']} times went by")
        check(f"{self.name}: the runtime sets the rhythm", pace["frames"] > frames and pace["in_time"] >= in_time * pace["frames"])
        for program in reversed(programs):
            program.end(signal.SIGKILL if program is self.service else signal.SIGINT)
        programs.clear()


def near(place, wanted, within):
    return place is not None and math.dist(place["at"], wanted) < within


def remote(folder):
    """The wearer of Monado's remote devices, and what it is told to have them."""
    port = free_port()
    config = folder / "monado/config_v0.json"
    config.parent.mkdir()
    config.write_text(json.dumps({"active": "remote", "remote": {"version": 0, "port": port, "view_count": 2}}))
    return MonadoWearer(port), {"P_OVERRIDE_ACTIVE_CONFIG": "remote"}


def sways(folder):
    run = Run("simulated", folder, {"XRT_COMPOSITOR_NULL": "1", "SIMULATED_ENABLE": "1", "SIMULATED_LEFT": "wmr", "SIMULATED_RIGHT": "wmr"})
    run.wait_for("head and both hands arrive", lambda seen: near(seen.get("eyes"), (0, 1.6, 0), 0.25)
                 and near(seen.get("left"), (-0.2, 1.3, -0.5), 0.1) and near(seen.get("right"), (0.2, 1.3, -0.5), 0.1))
    first = run.wearer()["eyes"]["at"]
    run.wait_for("the head sways", lambda seen: "eyes" in seen and math.dist(seen["eyes"]["at"], first) > 0.02)
    time.sleep(2)
    run.end(frames=15, in_time=0.2)


def works(folder):
    monado, env = remote(folder)
    run = Run("remote", folder, {**env, "XRT_COMPOSITOR_NULL": "1"})
    run.wait_for("the head arrives, and both hands, by joints", lambda seen: near(seen.get("eyes"), HEAD, 0.01)
                 and near(seen.get("left"), (-0.25, 1.1, 0.1), 0.01) and near(seen.get("right"), (0.3, 1.2, 0.1), 0.01))
    look(run.picture("rest.png"), run.ball()["at"])
    right, left = monado.hands["right"], monado.hands["left"]
    rest = run.ball()["size"][1]
    right.lead(BESIDE, 1.5)
    right.curl = 0.9
    run.wait_for("a hand of joints presses the ball", lambda _: run.ball()["size"][1] < rest - 0.003)
    run.user.wait("you hold the ball")
    run.press_menu(right, "opens", True)
    run.picture("held.png")
    run.press_menu(right, "closes", False)
    right.curl = 0
    right.lead((0.3, 1.2, 0.1), 1)
    left.by_joints = False
    run.wait_for("a hand without joints is where its controller is", lambda seen: near(seen.get("left"), (-0.261, 1.145, 0.096), 0.01))
    if SERVICE:
        run.service.end(signal.SIGKILL)
        run.user.wait("waiting for it")
        time.sleep(2)
        left.place = (-0.25, 1.3, 0.1)
        run.serve()
        run.user.wait("headset: Monado", 2)
        run.wait_for("after the service's end all goes on", lambda seen: near(seen.get("eyes"), HEAD, 0.01)
                     and near(seen.get("left"), (-0.261, 1.345, 0.096), 0.01))
        look(run.picture("back.png"), run.ball()["at"])
    run.end(frames=15, in_time=0.2)


def screen(display):
    """What that display shows, less what is black at the right and below."""
    image = ImageGrab.grab(xdisplay=display)
    return image.crop((0, 0, *(image.getbbox() or (0, 0, 2, 2))[2:]))


def shows(folder):
    if not shutil.which("Xvfb"):
        return print("skipped: what Monado's compositor shows: there is no Xvfb")
    monado, env = remote(folder)
    display = start("Xvfb", "-displayfd", "1", "-screen", "0", "2048x1200x24", "-nolisten", "tcp")
    name = ":" + display.wait("")
    run = Run("shown", folder, {**env, "XRT_COMPOSITOR_FORCE_XCB": "1", "XRT_COMPOSITOR_SCALE_PERCENTAGE": "40", "DISPLAY": name})
    run.wait_for("the head arrives", lambda seen: near(seen.get("eyes"), HEAD, 0.01))
    time.sleep(4)
    both = screen(name)
    both.save(OUT / "shown.png")
    print(f"Monado shows {both.width} × {both.height} pixels")
    look(halves(both), run.ball()["at"], DISPLAY)
    monado.hands["left"].lead((-0.3, 1, 0.35), 0.5)  # clear of the panel that a touch brings up
    monado.hands["right"].lead(BESIDE, 1.5)
    time.sleep(1)
    screen(name).save(OUT / "shown_pressed.png")  # for people to look at
    run.end(frames=5, in_time=0)


for way in (sways, works, shows):
    with tempfile.TemporaryDirectory() as folder:
        try:
            way(pathlib.Path(folder))
        finally:
            if "-v" in sys.argv:
                print(*(line for program in programs for line in program.lines), sep="\n")
            for program in programs:
                program.end(signal.SIGKILL)
            programs.clear()
finish()
