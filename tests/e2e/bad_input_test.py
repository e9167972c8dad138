#!/usr/bin/python3
"""bad_input_test.py BIN OUT: gives the real programs bad input of every kind and expects one clear line and exit code 2.
What can be used all the same (a surface that intersects itself, as scanned ones do) is warned of instead.

Each row: what is bad, how to make it, and the words that the message must hold (what, where, what is allowed).
"""

import gzip
import os
import pathlib
import signal
import struct
import subprocess
import sys
import tempfile

BIN, OUT = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
OUT.mkdir(parents=True, exist_ok=True)

SOFT = '''name = "bad"
[[soft]]
name = "organ"
{}
'''


def write(name, data):
    path = OUT / name
    path.write_bytes(data if isinstance(data, bytes) else data.encode())
    return path


def inr(x, y, z, voxels, type_="unsigned fixed", bits=8):
    header = (f"#INRIMAGE-4#{{\nXDIM={x}\nYDIM={y}\nZDIM={z}\nVDIM=1\nTYPE={type_}\nPIXSIZE={bits} bits\nSCALE=2**0\n"
              "CPU=decm\nVX=1\nVY=1\nVZ=1\n")
    return (header + "\n" * (256 - len(header) - 4) + "##}\n").encode() + voxels


def nifti(voxels, dims, datatype=16, bits=32):
    header = bytearray(352)
    struct.pack_into("<i", header, 0, 348)
    struct.pack_into("<8h", header, 40, 3, *dims, 1, 1, 1, 1)
    struct.pack_into("<hh", header, 70, datatype, bits)
    struct.pack_into("<8f", header, 76, 1, 1, 1, 1, 0, 0, 0, 0)
    struct.pack_into("<f", header, 108, 352)
    header[344:348] = b"n+1\0"
    return bytes(header) + voxels


def soft_scene(name, fields):
    return write(name + ".toml", SOFT.format(fields))


def rigid_scene(name, mesh):
    return write(name + ".toml", f'name = "bad"\n[[rigid]]\nname = "part"\nmesh = "{mesh}"\n')


cube = bytes(255 if 4 <= i % 16 < 12 and 4 <= i // 16 % 16 < 12 and 4 <= i // 256 < 12 else 0 for i in range(16**3))
write("truncated.inr", inr(16, 16, 16, cube[:1000]))
write("truncated.inr.gz", gzip.compress(inr(16, 16, 16, cube))[:-40])
write("huge.inr", inr(60000, 60000, 60000, b""))
write("labels.inr", inr(16, 16, 16, cube))
write("nan.nii", nifti(struct.pack("<f", float("nan")) * 16**3, (16, 16, 16)))
write("zero.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n1\n1 0 0 0\n$EndNodes\n$Elements\n0\n$EndElements\n")
# A tetrahedron and a copy of it pushed half through: two closed shells that cross.
tet = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
faces = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
points = tet + [(x + 0.2, y + 0.2, z + 0.2) for x, y, z in tet]
write("crossing.off", f"OFF\n8 8 0\n" + "".join("%g %g %g\n" % p for p in points)
      + "".join("3 %d %d %d\n" % f for f in faces + [tuple(i + 4 for i in f) for f in faces]))
tetrahedron = ("ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
               "element face 4\nproperty list uchar int vertex_index\nend_header\n"
               "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n")
write("crash.ply", tetrahedron.replace("3 0 3 2", "\x0e 0 3 2"))
write("organ.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
pipe = OUT / "pipe.toml"
if not pipe.exists():
    os.mkfifo(pipe)
write("nan.off", "OFF\n3 1 0\nnan 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")

ATLAS = 'name = "bad"\n[[atlas]]\nvolume = "labels.inr"\nlabels = "{}"\n'
write("bad.csv", "id,name\nx,liver\n")

CASES = [
    ("missing scene", OUT / "absent.toml", ["absent.toml"]),
    ("not TOML", write("syntax.toml", "name = [\n"), ["syntax.toml:"]),
    ("unknown key", soft_scene("unknown", 'shape = "ball"\nyoung = 3'), ["unknown.toml:", "young", "youngs_modulus"]),
    ("NaN in a scene", soft_scene("nan", 'shape = "ball"\nyoungs_modulus = nan'), ["nan.toml:", "youngs_modulus"]),
    ("out of range", soft_scene("range", 'shape = "ball"\npoisson_ratio = 0.6'), ["range.toml:", "poisson_ratio", "0.5"]),
    ("unknown model", soft_scene("model", 'shape = "ball"\nmodel = "jelly"'), ["jelly", "fem_corotational"]),
    ("missing volume", soft_scene("missing", 'volume = "absent.inr"\nlabel = 1'), ["absent.inr"]),
    ("truncated volume", soft_scene("truncated", 'volume = "truncated.inr"\nlabel = 255'), ["truncated.inr"]),
    ("truncated gzip", soft_scene("gzip", 'volume = "truncated.inr.gz"\nlabel = 255'), ["truncated.inr.gz"]),
    ("huge volume", soft_scene("huge", 'volume = "huge.inr"\nlabel = 1'), ["huge.inr"]),
    ("NaN voxels", soft_scene("nanvoxel", 'volume = "nan.nii"\nthreshold = 0.5'), ["nan.nii"]),
    ("label that isn't there", soft_scene("label", 'volume = "labels.inr"\nlabel = 7'), ["labels.inr", "7", "255"]),
    ("zero tetrahedra", soft_scene("zero", 'mesh = "zero.msh"'), ["zero.msh"]),
    ("a pipe as scene", pipe, ["pipe.toml", "is a pipe", "regular file"]),
    ("a scene nested deeply", write("deep.toml", 'name = "deep"\n[' + "a." * 300000 + "a]\n"), ["deep.toml:2", "32"]),
    ("a cell that is too fine", soft_scene("fine", 'shape = "ball"\nsize = [1, 1, 1]\ncell = 0.001'),
     ["organ", "tetrahedra", "allowed: a cell of"]),
    ("a cell that is too coarse", soft_scene("coarse", 'shape = "cylinder"\nsize = [0.01, 0.3, 0.01]\ncell = 0.3'),
     ["organ", "no tetrahedra", "use a finer one"]),
    ("label 0", soft_scene("label0", 'volume = "labels.inr"\nlabel = 0'), ["label0.toml:", "label = 0", "1 to 65535"]),
    ("an open surface where a solid is needed", soft_scene("surface", 'mesh = "organ.obj"'),
     ["organ: ", "organ.obj: not closed", "3 edges at the borders of holes"]),
    ("a table of labels with an id that is none", write("atlas.toml", ATLAS.format("bad.csv")),
     ["bad.csv:2", 'id = "x"', "[1, 65535]"]),
    ("a label map's table that is missing", write("lost.toml", ATLAS.format("lost.csv")), ["lost.toml: [[atlas]] 1", "lost.csv is missing"]),
    ("a surface with a control character for a length", rigid_scene("crash", "crash.ply"), ["crash.ply", "not a surface", "line 16", "OBJ"]),
    ("NaN in a surface", rigid_scene("nanoff", "nan.off"), ["nan.off"]),
]

failures = 0
for what, scene, words in CASES:
    run = subprocess.run([BIN / "prosector-server", str(scene), "--check", "--cache", str(OUT / "cache")],
                         capture_output=True, text=True, timeout=60)
    message = run.stderr.strip()
    good = run.returncode == 2 and all(w in message for w in words) and len(message.splitlines()) <= 3
    failures += not good
    print(f"{'ok    ' if good else 'FAILED'} {what}: exit {run.returncode}: {message}"
          + ("" if good else f"\n       expected exit 2 and {words}\n       stdout: {run.stdout[-400:]}"))

scene = rigid_scene("crossing", "crossing.off")
run = subprocess.run([BIN / "prosector-server", str(scene), "--check", "--cache", tempfile.mkdtemp(dir=OUT)],
                     capture_output=True, text=True, timeout=60)
good = run.returncode == 0 and "warning: intersects itself" in run.stdout
failures += not good
print(f"{'ok    ' if good else 'FAILED'} self-intersecting surface: exit {run.returncode}: warned")

run = subprocess.run([BIN / "prosector-server", str(soft_scene("named", 'shape = "ball"')), "--check", "--session", "*"],
                     capture_output=True, text=True, timeout=60)
good = run.returncode == 2 and 'session name "*" is not valid' in run.stderr
failures += not good
print(f"{'ok    ' if good else 'FAILED'} a session name that names many: exit {run.returncode}: {run.stderr.strip()}")

run = subprocess.run([BIN / "prosector-server", str(soft_scene("uncached", 'shape = "ball"')), "--check", "--cache", str(OUT / "organ.obj")],
                     capture_output=True, text=True, timeout=60)
good = run.returncode == 0 and "cannot write the cache " in run.stdout
failures += not good
print(f"{'ok    ' if good else 'FAILED'} a cache that can't be written: exit {run.returncode}: {run.stdout[-200:].strip()}")

# The scene tool ends as the server does, for the same fault.
absent = str(OUT / "absent" / "drafted.toml")
SCENE_TOOL_CASES = [
    ("an unknown key", 2, [soft_scene("unknown", 'shape = "ball"\nyoung = 3')]),
    ("a missing scene", 2, [OUT / "absent.toml"]),
    ("a draft of a missing file", 2, ["new", OUT / "absent.obj"]),
    ("a draft of an open surface", 2, ["new", OUT / "organ.obj", "--out", OUT / "drafted.toml"]),
    ("a draft that can't be written", 1, ["new", OUT / "organ.obj", "--rigid", "--out", absent]),
]
for what, status, arguments in SCENE_TOOL_CASES:
    run = subprocess.run([BIN / "prosector-scene", *map(str, arguments)], capture_output=True, text=True, timeout=60)
    good = run.returncode == status and run.stderr.strip()
    failures += not good
    print(f"{'ok    ' if good else 'FAILED'} {what}, by prosector-scene: exit {run.returncode}: {run.stderr.strip()}")

PLAY_CASES = [
    ("a recording that is missing", OUT / "lost.sqlite", ["lost.sqlite", "no such file"]),
    ("a recording that is none", write("none.sqlite", "no journal"), ["none.sqlite", "is not a journal"]),
    ("an empty recording", write("empty.sqlite", ""), ["empty.sqlite"]),
]
for what, recording, words in PLAY_CASES:
    run = subprocess.run([BIN / "prosector-server", "--play", str(recording)], capture_output=True, text=True, timeout=60)
    message = run.stderr.strip()
    good = run.returncode == 2 and all(w in message for w in words) and len(message.splitlines()) == 1
    failures += not good
    print(f"{'ok    ' if good else 'FAILED'} {what}: exit {run.returncode}: {message}")

DEVICES = write("devices.toml", "[tracker]\naddress = 'fastrak:/nonexistent'\n")
CLIENT_CASES = [
    ("no server", ["observe", "--session", "nobody-is-here", "--timeout", "1", "--display", "none"],
     ["nobody-is-here", "searched"]),
    ("an option's former name", ["observe", "--session", "nobody-is-here", "--patience", "1", "--display", "none"],
     ["--patience is deprecated", "use --timeout", "searched"]),
    ("bad size", ["observe", "--size", "800"], ["--size", "WIDTHxHEIGHT"]),
    ("is not a language", ["observe", "--language", "x y"], ["x y", "language tag"]),
    ("unknown driver", ["join", "--tracker", "magic:/dev/null"], ["magic", "fastrak"]),
    ("a field map that is none", ["join", "--config", write("no_map.toml", "[tracker]\naddress = 'fastrak:/dev/null'\nfield_map = 'no.toml'\n")],
     ["no.toml"]),
    ("points on a line", ["calibrate", "room", "--config", DEVICES, "--point=0,0,0", "--point=0.3,0,0", "--point=0.6,0,0"], ["one line"]),
    ("two points", ["calibrate", "room", "--config", DEVICES, "--point=0,0,0", "--point=0.3,0,0"], ["at least 3"]),
    ("a point of two numbers", ["calibrate", "room", "--config", DEVICES, "--point=1,2"], ["--point 1,2", "x,y,z"]),
    ("no such receiver", ["calibrate", "tip", "--config", DEVICES, "--station", "instrument"], ["instrument", "tracker.stations"]),
    ("no grid", ["calibrate", "field", "--config", DEVICES, "--grid", "2,2,2"], ["3 to 12 points"]),
    ("no glove", ["calibrate", "glove", "--config", DEVICES], ["devices.toml", "right glove"]),
    ("a tracker that is away", ["calibrate", "noise", "--config", DEVICES, "--timeout", "1"], ["timed out after 1 s"]),
    ("nobody's eyes", ["calibrate", "eyes", "--config", DEVICES, "--marks", "0.2", "--screen", "0.7", "--rod", "0.4"], ["between the eyes"]),
    ("a recording of nothing", ["record", "magic:/dev/null", "--out", OUT / "recording.csv"], ["magic", "fastrak"]),
    ("a key that is none", ["config", DEVICES, "--set", "tracker.colour=1"], ["tracker.colour", "no such key"]),
    ("a value that is not allowed", ["config", DEVICES, "--set", "eyes.distance=1"], ["eyes.distance", "from 0 to 0.2"]),
    ("a newer configuration", ["config", write("newer.toml", "version = 99\n")], ["newer.toml:1", "newer Prosector"]),
]
for what, arguments, words in CLIENT_CASES:
    run = subprocess.run([BIN / "prosector-client", *arguments], capture_output=True, text=True, timeout=60)
    good = run.returncode == 2 and all(w in run.stderr for w in words)
    failures += not good
    print(f"{'ok    ' if good else 'FAILED'} {what}: exit {run.returncode}: {run.stderr.strip()}")



def check(what, good, told):
    global failures
    failures += not good
    print(f"{'ok    ' if good else 'FAILED'} {what}: {told}")


PROGRAMS = ["server", "client", "scene", "bench", "fastrak-twin", "5dt-twin", "import"]
versions = {}
for program in PROGRAMS:
    path = BIN / f"prosector-{program}"
    run = subprocess.run([path, "--version"], capture_output=True, text=True, timeout=60)
    versions[program] = run.stdout.strip().split(",")[0]
    check(f"{path.name} --version", run.returncode == 0 and versions[program].startswith(path.name + " "), run.stdout.strip())
    run = subprocess.run([path, "--no-such-option"], capture_output=True, text=True, timeout=60)
    check(f"{path.name} --no-such-option", run.returncode == 2 and run.stderr, f"exit {run.returncode}")
check("one version", len({line.split()[1] for line in versions.values()}) == 1, versions)

# Ctrl-C ends what takes long, here a solid of a million tetrahedra, within a moment.
scene = soft_scene("long", 'shape = "ball"\nsize = [1, 1, 1]\ncell = 0.016')
run = subprocess.Popen([BIN / "prosector-server", str(scene), "--check", "--cache", tempfile.mkdtemp(dir=OUT)],
                       stdout=subprocess.PIPE, text=True)
lines = [run.stdout.readline() for _ in range(2)]
run.send_signal(signal.SIGINT)
try:
    status = run.wait(timeout=10)
except subprocess.TimeoutExpired:
    run.kill()
    status = "none within 10 s"
check("Ctrl-C while meshing", status == -signal.SIGINT and "takes a while" in lines[1], f"{status}: {lines[1].strip()}")

# A picture that can't be kept shows in the exit code.
scene = write("dark.toml", 'name = "dark"\n[[rigid]]\nname = "block"\nfixed = true\n[[rigid.part]]\n')
server = subprocess.Popen([BIN / "prosector-server", str(scene), "--session", "lost-pictures", "--domain", "89"],
                          stdout=subprocess.PIPE, text=True)
said = []
for line in server.stdout:
    said.append(line)
    if "is open" in line:
        break
check("a scene without light", any("no light" in line for line in said), "hinted at")
for file, status, words in [(OUT / "absent" / "a.png", 1, "a.png: cannot write"), (OUT / "a.png", 0, "everything is here")]:
    for _ in range(3):  # on a busy machine the scene may not be here in time
        run = subprocess.run([BIN / "prosector-client", "observe", "--session", "lost-pictures", "--domain", "89",
                              "--display", "osmesa", "--size", "160x120", "--seconds", "3", "--screenshot", str(file)],
                             capture_output=True, text=True, timeout=60)
        if "everything is here" in run.stdout:
            break
    check(f"a screenshot to {file.parent.name}", run.returncode == status and words in run.stdout, f"exit {run.returncode}")
server.terminate()
check("a server that is asked to end", server.wait(timeout=20) == 0, "exit 0")

sys.exit(1 if failures else 0)
