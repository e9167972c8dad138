#!/usr/bin/python3
"""full_disk_test.py BIN OUT: a disk fills up while a client records a video on it and the server its journal. Each says so once,
what it wrote so far is whole, and the session goes on. Needs root, to mount a small disk of memory; skipped (77) without.
"""

import contextlib
import os
import pathlib
import re
import signal
import struct
import subprocess
import sys
import time

BIN, OUT = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
SKIPPED = 77
DISK_MIB = 48
SCENE = '''name = "full disk"
[[rigid]]
name = "table"
fixed = true
[[rigid.part]]
size = [1, 0.1, 1]
[[rigid]]
name = "cube"
position = [0, 0.4, 0]
[[rigid.part]]
size = [0.1, 0.1, 0.1]
'''


def expect(condition, what):
    if not condition:
        raise AssertionError(what)
    print(f"ok     {what}")


def wait_for(condition, seconds, what):
    end = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > end:
            raise AssertionError(f"within {seconds} s: {what}")
        time.sleep(0.05)
    print(f"ok     {what}")


@contextlib.contextmanager
def small_disk(path):
    path.mkdir(parents=True, exist_ok=True)
    mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={DISK_MIB}m", "prosector-full-disk", path],
                             capture_output=True, text=True)
    if mounted.returncode != 0:
        print(f"skipped: a small disk can't be mounted (needs root): {mounted.stderr.strip()}")
        sys.exit(SKIPPED)
    try:
        yield path
    finally:
        subprocess.run(["umount", "--lazy", path], check=False)


@contextlib.contextmanager
def running(log, *arguments):
    with open(log, "w") as out:
        process = subprocess.Popen(arguments, stdout=out, stderr=subprocess.STDOUT)
    try:
        yield process
    finally:
        if process.poll() is None:
            process.kill()
        process.wait()


def fill(disk, left_bytes):
    """Writes until only so many bytes are left."""
    with open(disk / "ballast", "ab", buffering=0) as ballast:
        with contextlib.suppress(OSError):
            while (free := os.statvfs(disk).f_bavail * os.statvfs(disk).f_frsize) > left_bytes:
                ballast.write(bytes(min(free - left_bytes, 1 << 20)))


def is_whole_avi(file):
    """Its length as the header says it, and an index at its end."""
    data = file.read_bytes()
    return (data[:4] == b"RIFF" and struct.unpack_from("<I", data, 4)[0] == len(data) - 8
            and re.search(rb"idx1", data) is not None)


def main():
    if os.geteuid() != 0:
        print("skipped: needs root, to mount a small disk")
        sys.exit(SKIPPED)
    OUT.mkdir(parents=True, exist_ok=True)
    scene = OUT / "scene.toml"
    scene.write_text(SCENE)
    session = ["--session", f"full-disk-{os.getpid()}", "--domain", "76"]
    server_log, client_log = OUT / "server.log", OUT / "client.log"
    said = lambda log, text: log.read_text().count(text)
    lines = lambda: len(re.findall(r"x\d+\.\d+ real time", server_log.read_text()))
    with small_disk(OUT / "disk") as disk:
        with running(server_log, BIN / "prosector-server", scene, *session, "--cache", OUT / "cache",
                     "--journal", disk / "journal.sqlite") as server, \
             running(client_log, BIN / "prosector-client", "observe", *session, "--name", "observer",
                     "--display", "offscreen", "--size", "320x240", "--fps", "10", "--seconds", "300",
                     "--record", disk / "video.avi") as client:
            wait_for(lambda: (disk / "video.avi").exists() and (disk / "video.avi").stat().st_size > 20_000, 60,
                     "a video is being recorded")
            fill(disk, 4 << 20)
            wait_for(lambda: said(client_log, "recording ended after"), 30, "the client says that recording has ended")
            expect(is_whole_avi(disk / "video.avi"), "the video is whole up to there")

            fill(disk, 0)
            wait_for(lambda: said(server_log, "the session continues without"), 60, "the server says that its journal has stopped")
            before = lines()
            wait_for(lambda: lines() > before + 2, 30, "the server runs on")
            expect(client.poll() is None and server.poll() is None, "client and server are there")
            expect(said(client_log, "recording ended after") == 1, "the client has said it once")
            expect(said(server_log, "the session continues without") == 1, "the server has said it once")

            client.send_signal(signal.SIGTERM)
            expect(client.wait(30) == 1, "the client leaves with status 1: its recording is not whole")
            wait_for(lambda: said(server_log, "observer is disconnected"), 10, "the server has noticed")
            server.send_signal(signal.SIGTERM)
            expect(server.wait(30) == 0, "the server ends with status 0")
        (disk / "ballast").unlink()
        replay = subprocess.run([BIN / "prosector-server", "--replay", disk / "journal.sqlite", "--cache", OUT / "cache"],
                                capture_output=True, text=True, timeout=60)
        expect(replay.returncode == 0, f"the journal up to there runs again: {replay.stdout.strip()[-200:]}")


if __name__ == "__main__":
    try:
        main()
    except AssertionError as error:
        for log in (OUT / "server.log", OUT / "client.log"):
            print(f"--- {log.name}\n{log.read_text()[-1500:] if log.exists() else ''}")
        sys.exit(f"FAILED {error}")
