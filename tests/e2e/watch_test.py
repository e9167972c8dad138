#!/usr/bin/python3
"""watch_test.py BIN OUT: a scene that changes on disk while its server runs with --watch. Who watches stays and sees the new one;
a file that doesn't load leaves the old one and is told of once."""
import json
import os
import pathlib
import subprocess
import sys
import threading
import time

BIN, OUT = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
OUT.mkdir(parents=True, exist_ok=True)
ENV = {**os.environ, "LC_ALL": "C"}

HEAD = 'name = "watched"\nlabels = "names.csv"\n[[light]]\nkind = "directional"\n'
BALL = ('[[soft]]\nname = "{}"\nshape = "ball"\nsize = [0.1, 0.1, 0.1]\ncell = 0.03\nsurface_cell = 0.02\n'
        'gravity = false\nposition = [{}, 1, 0]\n')


class Program:
    """A program whose lines can be waited for."""

    def __init__(self, *words):
        self.lines = []
        self.process = subprocess.Popen([str(w) for w in words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                        stdin=subprocess.DEVNULL, env=ENV)
        threading.Thread(target=self.read, daemon=True).start()

    def read(self):
        for line in self.process.stdout:
            self.lines.append(line.rstrip("\n"))

    def count(self, words):
        return sum(words in line for line in list(self.lines))

    def wait(self, words, times=1, seconds=40):
        end = time.monotonic() + seconds
        while self.count(words) < times:
            if time.monotonic() > end or (self.process.poll() is not None and self.count(words) < times):
                sys.exit(f"FAILED: no {times} x \"{words}\" in:\n" + "\n".join(self.lines))
            time.sleep(0.05)


def write(name, text):
    """Writes in two pieces, as an editor may."""
    half = len(text) // 2
    with open(OUT / name, "w") as file:
        file.write(text[:half])
        file.flush()
        time.sleep(0.1)
        file.write(text[half:])


write("names.csv", "name,name.de\nfirst,erste\n")
write("scene.toml", HEAD + BALL.format("first", -0.1))
log = OUT / "log.jsonl"
server = Program(BIN / "prosector-server", OUT / "scene.toml", "--watch", "--session", f"watch{os.getpid()}", "--cache", OUT / "cache")
client = None
try:
    server.wait("is open")
    client = Program(BIN / "prosector-client", "observe", "--session", f"watch{os.getpid()}", "--name", "Watcher", "--display", "none",
                     "--timeout", "20", "--session-log", log)
    server.wait("Watcher joins")

    write("scene.toml", HEAD + BALL.format("first", -0.1) + "[[soft]]\nname = 7\n")
    server.wait("the old scene continues")
    time.sleep(1.5)
    assert server.count("the old scene continues") == 1, "told of more than once"
    assert any("scene.toml:" in line and "name = 7" in line for line in server.lines), server.lines
    assert server.count("is open") == 1, "the old scene ended"

    write("scene.toml", HEAD + BALL.format("first", -0.1) + BALL.format("second", 0.1))
    server.wait("is open", times=2)
    server.wait("Watcher joins", times=2)

    write("names.csv", "name,name.de\nfirst,erste\nsecond,zweite\n")  # what the scene names counts, too
    server.wait("is open", times=3)
    server.wait("Watcher joins", times=3)
    time.sleep(1.5)
    assert client.process.poll() is None, "the observer didn't stay:\n" + "\n".join(client.lines)
finally:
    for program in (client, server):
        if program is not None:
            program.process.terminate()
            program.process.wait(20)
last = json.loads(log.read_text().splitlines()[-1])
assert {"first", "second"} <= set(last["parts"]), last
print("watch: the scene was loaded anew twice, and refused once; the observer stayed")
