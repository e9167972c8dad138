#!/usr/bin/env python3
"""atlas_scene.py ATLAS.nii.gz OUT.toml: writes a scene in which each label of a labelled volume of bytes is a soft organ.

Meant for the AAL atlas of Debian's mricron-data (Tzourio-Mazoyer et al. 2002), which deploy/fetch_anatomy.sh takes out of it: 116
regions of a brain that lie against each other, each held in its place. The scene names the volume by its file's name.
"""
import collections
import colorsys
import gzip
import pathlib
import struct
import sys

HEAD = """name = "brain atlas"
description = "{count} regions of a brain, each a soft organ"

[camera]
eye = [0.25, 1.25, 0.35]
target = [0, 1.05, 0]

[[rigid]]
name = "table"
fixed = true
surface = "metal"
color = [0.5, 0.5, 0.55]

  [[rigid.part]]
  size = [0.8, 0.04, 0.8]
  position = [0, 0.88, 0]

[[light]]
name = "lamp"
kind = "spot"
position = [0.4, 2.0, 0.6]
direction = [-0.35, -0.95, -0.55]
cone = 0.6

[[light]]
name = "room"
kind = "point"
position = [-1.2, 2.2, 1]
intensity = 0.5
"""

REGION = """
[[soft]]
name = "region {label}"
volume = "{volume}"
label = {label}
position = [0, 1.0, 0]
rotation = [0.70710678, -0.70710678, 0, 0]  # the volume's z is up
cell = {cell}
surface_cell = 0.005
youngs_modulus = 3000
damping_mass = 4
gravity = false
anatomy = true
group = "brain"  # what lies against each other at rest needs no contacts
touches = ["default", "hand"]
color = [{color}]

  [[soft.attach]]
  center = [0, 1.0, 0]
  radius = 0.2
  stiffness = 2e5
"""


def cell_of(volume):
    """m: small regions need fine cells; volume in m3."""
    return 0.005 if volume < 5e-6 else 0.0065 if volume < 12e-6 else 0.009


def volumes_of(path):
    """m3 of each label."""
    volume = gzip.open(path).read()
    if len(volume) < 352 or volume[344:347] != b"n+1" or struct.unpack("<h", volume[70:72])[0] != 2:
        sys.exit(f"{path}: expected a NIfTI-1 volume of bytes in one file")
    start = int(struct.unpack("<f", volume[108:112])[0])
    x, y, z = struct.unpack("<3f", volume[80:92])  # mm
    counts = collections.Counter(volume[start:])
    return {label: count * x * y * z * 1e-9 for label, count in sorted(counts.items()) if label != 0}


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    atlas, out = map(pathlib.Path, sys.argv[1:])
    volumes = volumes_of(atlas)
    text = HEAD.format(count=len(volumes))
    for place, (label, volume) in enumerate(volumes.items()):
        rgb = colorsys.hsv_to_rgb(place / len(volumes), 0.55, 0.6)
        text += REGION.format(label=label, volume=atlas.name, cell=cell_of(volume),
                              color=", ".join(f"{c:.2f}" for c in rgb))
    out.write_text(text)


main()
