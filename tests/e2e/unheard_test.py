#!/usr/bin/python3
"""unheard_test.py BIN OUT: a damaged datagram makes the server's DDS reader drop all later samples of a client's hand: a copy of
one of its datagrams with a sequence number far ahead. The client has to notice that it is no longer heard, say so, and reconnect.
Runs in a network namespace of its own, which it makes; ends as skipped (77) where it can't."""
import atexit
import collections
import os
import pathlib
import shutil
import socket
import struct
import subprocess
import sys
import time

from checks import check, finish
from program import Program
from session_log import SessionLog

BIN, OUT = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
SWAY = OUT / "sway.csv"  # a hand that goes to and fro
SCENE = pathlib.Path(__file__).parents[2] / "deploy/scenes/minimal.toml"
DATA = 0x15  # the submessage that carries a sample (RTPS 2.5, 9.4.5.3)
USER_PORT = 7411  # of the first server of domain 0 (RTPS 2.5, 9.6.2.1)

if "inside" not in sys.argv:
    alone = ["unshare", "--map-root-user", "--net", "bash", "-c", 'ip link set lo up multicast on && exec "$@"', "-"]
    if not shutil.which("unshare") or not shutil.which("ip") or subprocess.run([*alone, "true"], stderr=subprocess.DEVNULL).returncode:
        print("SKIPPED: no network namespace can be made")
        sys.exit(77)
    os.execvp(alone[0], [*alone, sys.executable, *sys.argv, "inside"])

shutil.rmtree(OUT, ignore_errors=True)
OUT.mkdir(parents=True)


programs = []


def start(*words):
    programs.append(Program(*words))
    return programs[-1]


def samples(datagram):
    """Of an RTPS message, each sample's place in it and its writer, as (offset of the sequence number, writer's id)."""
    at = 20
    while datagram[:4] == b"RTPS" and at + 4 <= len(datagram):
        kind, flags = datagram[at], datagram[at + 1]
        length = struct.unpack_from("<H" if flags & 1 else ">H", datagram, at + 2)[0]
        if kind == DATA:
            yield at + 16, datagram[8:20] + datagram[at + 12:at + 16]
        at += 4 + length if length else len(datagram)


def to_the_server(seconds):
    """What is sent to the server's port for samples, as UDP payloads."""
    tap = socket.socket(socket.AF_PACKET, socket.SOCK_DGRAM, socket.htons(0x0800))
    tap.bind(("lo", 0))
    tap.settimeout(0.2)
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        try:
            packet = tap.recv(65536)
        except TimeoutError:
            continue
        udp = packet[4 * (packet[0] & 15):]
        if packet[9] == 17 and struct.unpack_from(">H", udp, 2)[0] == USER_PORT:
            yield udp[8:]


def hand():
    """Where ada's right hand is, as the observer knows it."""
    return [line["people"]["ada"].get("right") for line in LOG.lines() if "ada" in line["people"]][-1:]


def moves(seconds=2):
    before = hand()
    time.sleep(seconds)
    return hand() != before


def end_all():
    for program in programs:
        program.end()


atexit.register(end_all)
LOG = SessionLog(OUT / "observer.jsonl")
SWAY.write_text("time,station,x,y,z,qw,qx,qy,qz\n" + "".join(
    f"{t / 2},1,{0.05 * (-1) ** t},1.3,0.3,1,0,0,0\n" for t in range(400)))
start(BIN / "prosector-fastrak-twin", "--script", SWAY, "--link", OUT / "tracker", "--room-device", "0,1,1,1,0,0,0")
server = start(BIN / "prosector-server", SCENE, "--session", "unheard", "--summary", OUT / "server.json")
server.wait("is open on this machine")
observer = start(BIN / "prosector-client", "observe", "--session", "unheard", "--display", "none", "--session-log", LOG.file)
observer.wait("everything is here")
client = start(BIN / "prosector-client", "join", "--name", "ada", "--session", "unheard", "--display", "none", "--tracker",
               f"fastrak:{OUT / 'tracker'}")
client.wait("everything is here")
check("the server hears the client", LOG.wait(moves, 20))

written, example = collections.Counter(), {}
for datagram in to_the_server(3):
    for offset, writer in samples(datagram):
        written[writer] += 1
        example[writer] = (offset, datagram)
writer, count = written.most_common(1)[0]
offset, datagram = example[writer]
check(f"one writer sends most samples: {count} in 3 s", count >= 20)
high, low = struct.unpack_from("<iI", datagram, offset)
damaged = bytearray(datagram)
struct.pack_into("<iI", damaged, offset, high + 256, low)
socket.socket(socket.AF_INET, socket.SOCK_DGRAM).sendto(damaged, ("127.0.0.1", USER_PORT))
check("a damaged datagram makes it deaf to the client", LOG.wait(lambda: not moves(1), 10))

began = time.monotonic()
client.wait("reconnected", seconds=30)
said = time.monotonic() - began
check("it is heard again", LOG.wait(lambda: moves(1), 20))
print(f"the client said so {said:.1f} s later, and was heard again after {time.monotonic() - began:.1f} s")
server.wait("ada joins", times=2)
check("nothing was refused", not any("refused" in line for line in client.lines))
for program in client, observer, server:
    program.process.terminate()
    check(f"{pathlib.Path(program.process.args[0]).name} ends cleanly", program.ended(20) == 0)
finish()
