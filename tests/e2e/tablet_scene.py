"""What a synthetic camera sees of a user with a bare hand and a tablet: the scene's files, the hand's way, the client's configuration."""

import math

import numpy

TABLE = 0.9  # m
FLAT = [0.70710678, -0.70710678, 0, 0]
EYE, TARGET = numpy.array([0.08, 1.64, 0.36]), numpy.array([0.08, 0.98, 0.06])  # of the camera
TABLET = numpy.array([0.2, 1.02, 0.10])  # of its middle
OPEN, FIST, POINT = [0.1] * 5, [0.8, 1, 1, 1, 1], [0.7, 0.05, 0.95, 0.95, 0.95]
RIGHT_INDEX = [(-0.026, 0, -0.090), (0.043, 0.025, 0.020), 0.06]  # common/hand.cpp: knuckle, lengths, yaw


def quaternion(m):
    """Of a rotation matrix: w, x, y, z."""
    q = numpy.array([1 + m[0, 0] + m[1, 1] + m[2, 2], 1 + m[0, 0] - m[1, 1] - m[2, 2], 1 - m[0, 0] + m[1, 1] - m[2, 2], 1 - m[0, 0] - m[1, 1] + m[2, 2]])
    q = numpy.sqrt(numpy.maximum(q, 0)) / 2
    signs = [1, m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1]]
    return numpy.copysign(q, signs)


def looking(eye, target):
    """The rotation of who looks from there to there: x right, y up, z back."""
    back = (eye - target) / numpy.linalg.norm(eye - target)
    right = numpy.cross((0, 1, 0), back)
    right /= numpy.linalg.norm(right)
    return numpy.stack((right, numpy.cross(back, right), back), 1)


def about(axis, angle):
    x, y, z = axis
    k = numpy.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return numpy.eye(3) + math.sin(angle) * k + (1 - math.cos(angle)) * k @ k


def index_tip(bend):
    """In the right wrist's frame."""
    knuckle, lengths, yaw = RIGHT_INDEX
    at, turn = numpy.array(knuckle), about((0, 1, 0), yaw)
    for length, share in zip(lengths, (1, 1, 2 / 3)):
        turn = turn @ about((1, 0, 0), -bend * share * math.pi / 2)
        at = at + turn @ (0, 0, -length)
    return at


def wrist_for(tip, turn, bend):
    return numpy.array(tip) - turn @ index_tip(bend)


class Scene:
    """A way of the hand, key by key and again and again, and all files of it in a folder."""

    def __init__(self, folder, rate=15):
        self.folder, self.rate, self.keys = folder, rate, []
        self.tablet_turn = looking(EYE + (0, 0.05, 0), TABLET)
        folder.mkdir(parents=True, exist_ok=True)

    def hold(self, time, wrist, turn, bends):
        self.keys.append([time, 1, *wrist, *quaternion(turn), *bends])

    def on_tablet(self, x, y, z):
        """A place of the panel's frame in the room."""
        return TABLET + self.tablet_turn @ (x, y, z)

    def write(self, end, sway=0.0):
        """`sway`: m, by which the camera goes to and fro."""
        rows = [*self.keys, [self.keys[-1][0] + 1, *self.keys[0][1:]]]
        head = "time,station,x,y,z,qw,qx,qy,qz,thumb,index,middle,ring,little\n"
        (self.folder / "hand.csv").write_text(head + "\n".join(",".join(f"{x:.6g}" for x in row) for row in rows) + "\n")
        trembles = [[t, *(TABLET + 0.003 * numpy.array([math.sin(1.3 * t), math.sin(2.1 * t), math.sin(0.7 * t)])), *quaternion(self.tablet_turn)]
                    for t in numpy.arange(0, end, 0.5)]
        (self.folder / "tablet.csv").write_text("time,x,y,z,qw,qx,qy,qz\n" + "\n".join(",".join(f"{x:.6g}" for x in row) for row in trembles) + "\n")
        ways = []
        for k in range(int(end / 2) + 1):
            eye = EYE + sway * numpy.array([math.sin(1.5 * k), 0.2 * math.cos(1.5 * k), 0])
            ways.append([2 * k, *eye, *quaternion(looking(eye, TARGET))])
        (self.folder / "camera.csv").write_text("time,x,y,z,qw,qx,qy,qz\n" + "\n".join(",".join(f"{x:.6g}" for x in row) for row in ways) + "\n")
        board = f"position = [0, {TABLE}, 0.05]\norientation = {FLAT}\n"
        (self.folder / "scene.toml").write_text(
            f'ambient = 0.6\n[[camera]]\nrate = {self.rate}\nrays = 2\ndistortion = [-0.18, 0.03, 0, 0, 0]\nmotion = "camera.csv"\n'
            f"[[plate]]\nwidth = 1.4\nheight = 1.0\nposition = [0, {TABLE - 0.0005}, 0]\norientation = {FLAT}\nwood = true\n"
            f'[[board]]\nknown = "table"\n{board}[[board]]\nknown = "tablet"\nmotion = "tablet.csv"\n[[hand]]\nmotion = "hand.csv"\nstation = 1\nloop = true\n')
        self.address = f"hands:synthetic:{self.folder / 'scene.toml'}"
        (self.folder / "client.toml").write_text(
            f'[tracker]\naddress = "{self.address}"\n[tracker.table]\nboard = "table"\n{board}[tracker.stations]\ntablet.station = 3\n')
        return self.folder / "client.toml"
