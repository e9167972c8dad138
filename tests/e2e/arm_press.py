"""A simulated haptic arm in a real session: its twin, the client that it belongs to, and what both of them log."""

import csv
import json
import pathlib
import statistics
import tempfile
import time

from program import Program

HERE = pathlib.Path(__file__).parent

# What plays an arm, by driver: a program and where it listens (none: at a socket), or the arm's name and a library.
PROGRAMS = {"omni-twin": ("prosector-omni-twin", None), "inverse3": ("prosector-inverse3-twin", "0"),
            "vrpn": ("prosector-vrpn-twin", "0")}
LIBRARIES = {"hdapi": ("default", "libHD.so"), "dhd": ("0", "libdhd.so")}


class ArmPress:
    """A simulated arm whose modelled hand presses at a place of the room, m, and the user whose arm it is."""

    def __init__(self, binaries, out, name, place, from_behind=True, driver="omni-twin"):
        self.binaries, self.out, self.name, self.driver = binaries, out, name, driver
        self.socket = pathlib.Path(tempfile.mkdtemp()) / "omni"  # a short path: sockets' are bounded
        # Where the arm stands: its inkwell is farther away than it, and lower than the place.
        self.stand = [place[0], place[1] + 0.04, place[2] - 0.03 if from_behind else place[2] + 0.03]
        self.turn = [1, 0, 0, 0] if from_behind else [0, 0, 1, 0]
        self.place = place
        self.programs = []

    def start(self, *words, env=None):
        self.programs.append(Program(*words, env=env))
        return self.programs[-1]

    def write_script(self, above, deep, at=1.5):
        """The way of the hand that holds it: from `above` (m) over the place to `deep` below it, by then, s."""
        x, y, z = self.place
        rows = [f"0,{x},{y + above},{z}", f"{at},{x},{y - deep},{z}", f"120,{x},{y - deep},{z}"]
        script = self.out / f"{self.name}_press.csv"
        script.write_text("time,x,y,z\n" + "\n".join(rows) + "\n")
        return script

    def start_twin(self, script):
        """Starts what plays the arm. Returns its address, and what the client's environment has to say."""
        stand = ",".join(map(str, self.stand + self.turn))
        words = ["--script", script, "--room-arm", stand, "--log", self.out / f"{self.name}.csv"]
        if self.driver in LIBRARIES:  # the twin is in the client
            words += ["--turns"] if self.driver == "dhd" else []
            library = self.binaries.parent / "lib/twins" / LIBRARIES[self.driver][1]
            return f"{self.driver}:{LIBRARIES[self.driver][0]}@{library}", {"PROSECTOR_TWIN": " ".join(map(str, words))}
        program, at = PROGRAMS[self.driver]
        twin = self.start(self.binaries / program, at or self.socket, "--wait-client", *words)
        return twin.wait("ready").removeprefix("ready: "), {}

    def write_config(self, address):
        config = (HERE / "arm_client.toml").read_text().replace("omni-twin:/tmp/omni", address)
        config = config.replace("[0, 1.07, -0.03]", f"{self.stand}\norientation = {self.turn}")
        (self.out / f"{self.name}.toml").write_text(config)

    def join(self, script, *words):
        """Starts the twin, whose hand goes by the script, and its user's client."""
        address, env = self.start_twin(script)
        self.write_config(address)
        user = self.start(self.binaries / "prosector-client", "join", "--name", "Feeler", "--display", "none", "--config",
                          self.out / f"{self.name}.toml", "--session-log", self.out / f"{self.name}.jsonl", "--timeout", "40", *words, env=env)
        user.wait("ready")
        return user

    def rows(self, since=0.0):
        """Rows of the twin's log, as numbers, from that monotonic time (s) on."""
        with open(self.out / f"{self.name}.csv") as file:
            rows = []
            for row in csv.DictReader(file):
                try:
                    rows.append({key: float(value) for key, value in row.items()})
                except (TypeError, ValueError):
                    break  # the line that is being written
        return [row for row in rows if row["time_ns"] >= 1e9 * since]

    def told_force(self):
        """The force of the user's hand as the server told it last; a line is written when something changes. N, on the tissue."""
        told = 0
        for line in open(self.out / f"{self.name}.jsonl"):
            try:
                touch = json.loads(line)["touches"].get("Feeler, right")
            except json.JSONDecodeError:
                break
            told = -touch["force"][1] if touch else 0
        return told

    def measure(self, seconds):
        """What the arm does for so long: its mean force (N), depth below the place and swing (m), and its least energy so far (J)."""
        begin = time.monotonic()
        time.sleep(seconds)
        rows = self.rows(begin)
        height = [row["y"] for row in rows]
        return {
            "force": statistics.mean(row["fy"] for row in rows),
            "depth": self.place[1] - statistics.mean(height),
            "swing": max(height) - min(height),
            "energy": min(row["energy"] for row in self.rows()),
        }

    def limp(self, since):
        """How long after that moment nothing was felt any more (s; none: it still is), and the largest step of force meanwhile (N)."""
        rows = self.rows(since)
        end = next((1e-9 * row["time_ns"] - since for row in rows if abs(row["fy"]) < 0.02), None)
        return end, max(abs(b["fy"] - a["fy"]) for a, b in zip(rows, rows[1:]))

    def feels(self, force, seconds):
        """Waits until at least so much is felt, N. False: it isn't in that time."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            if any(row["fy"] > force for row in self.rows(time.monotonic() - 0.5)):
                return True
            time.sleep(0.2)
        return False

    def close(self, how):
        for program in self.programs:
            program.end(how)
        self.socket.unlink(missing_ok=True)
        self.socket.parent.rmdir()
