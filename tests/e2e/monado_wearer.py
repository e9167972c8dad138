"""The wearer of a headset that Monado's `remote` driver simulates: it listens on TCP, and takes all devices' states in one packet, which is
native in byte order: header; two views of 4 angles and a pose, pad; head; two controllers."""

import socket
import struct
import threading
import time

from openxr_eyes import FOV, HEAD, TURN

LAYOUT = "=8s" + 2 * "4f7f4x" + "7f4?" + 2 * "7f6f5f8f16?"


def pose(place, turn=(1, 0, 0, 0)):
    """Orientation first; `turn`: w, x, y, z."""
    return [*turn[1:], turn[0], *place]


class Hand:
    def __init__(self, place):
        self.place, self.turn = place, (1, 0, 0, 0)
        self.curl = self.trigger = 0.0
        self.by_joints, self.menu = True, False

    def lead(self, place, seconds):
        """Takes the hand there, straight on."""
        begin, began = self.place, time.monotonic()
        while (way := min(1, (time.monotonic() - began) / seconds)) < 1:
            self.place = [a + (b - a) * way for a, b in zip(begin, place)]
            time.sleep(0.01)
        self.place = place

    def fields(self):
        keys = [self.by_joints, True, False, False, self.menu] + 11 * [False]  # joints, there, system, touched, A, …
        return [*pose(self.place, self.turn), *6 * [0.0], *5 * [self.curl], self.trigger, *7 * [0.0], *keys]


class MonadoWearer:
    """Stands as openxr_eyes says, and holds both hands where `hands` says."""

    def __init__(self, port):
        self.hands = {"left": Hand((-0.25, 1.1, 0.1)), "right": Hand((0.3, 1.2, 0.1))}
        self.port = port
        threading.Thread(target=self.run, daemon=True).start()

    def packet(self):
        views = [[*FOV[eye][:4], *pose((FOV[eye][4], 0, 0))] for eye in ("left", "right")]
        return struct.pack(LAYOUT, b"mndrmt3\0", *views[0], *views[1], *pose(HEAD, TURN), True, False, False, False,
                           *self.hands["left"].fields(), *self.hands["right"].fields())

    def run(self):
        while True:
            try:
                with socket.create_connection(("127.0.0.1", self.port)) as line:
                    while True:
                        line.sendall(self.packet())
                        time.sleep(0.01)
            except OSError:  # not there yet, or gone
                time.sleep(0.1)
