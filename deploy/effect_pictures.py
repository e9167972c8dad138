#!/usr/bin/env python3
"""Draws each effect on and off, side by side, for docs/understand/pictures.md.

deploy/effect_pictures.py [--client PROGRAM] [--out FOLDER]
  --client  the client to draw with (default build/release/bin/prosector-client)
  --out     where effect-*.png go (default docs/pictures/scenes)
"""
import argparse
import pathlib
import struct
import subprocess
import sys
import tempfile
import zlib

root = pathlib.Path(__file__).resolve().parent.parent

# Effect, scene, view, its state in the right picture, size, part that is shown (left, top, width, height), enlarged.
pictures = [
    ("relief", "abdomen", "close", "off", (400, 300), (0, 0, 400, 300), 1),
    ("film", "abdomen", "close", "off", (400, 300), (0, 0, 400, 300), 1),
    ("translucency", "abdomen", "close", "off", (400, 300), (0, 0, 400, 300), 1),
    ("reflections", "abdomen", "scene", "off", (400, 300), (0, 0, 400, 300), 1),
    ("parallax", "abdomen", "scene", "off", (800, 600), (300, 420, 200, 150), 2),
    ("shafts", "cut", "scene", "off", (400, 300), (0, 0, 400, 300), 1),
    ("refraction", "curves", "glass", "off", (400, 300), (0, 0, 400, 300), 1),
    ("shadows", "rigid", "scene", "off", (400, 300), (0, 0, 400, 300), 1),
    ("edges", "ropes", "scene", "off", (400, 300), (130, 100, 133, 100), 3),
    ("ambient_occlusion", "abdomen", "close", "off", (400, 300), (0, 0, 400, 300), 1),
]


def predicted(kind, left, above, corner):
    """Returns what a byte of a PNG's row is counted from, by the row's filter."""
    if kind == 4:  # Paeth
        estimate = left + above - corner
        return min((left, above, corner), key=lambda value: abs(estimate - value))
    return (0, left, above, (left + above) // 2)[kind]


def read_png(file):
    """Returns width and rows of a picture of 8 bits each of red, green and blue."""
    data, place, packed = file.read_bytes(), 8, b""
    while place < len(data):
        length, kind = struct.unpack(">I4s", data[place : place + 8])
        body = data[place + 8 : place + 8 + length]
        if kind == b"IHDR":
            width, height, depth, colours = struct.unpack(">IIBB", body[:10])
            if (depth, colours) != (8, 2):
                sys.exit(f"{file}: {depth} bits of colour type {colours}; 8 bits of RGB (2) are read")
        if kind == b"IDAT":
            packed += body
        place += 12 + length
    raw, stride, rows = zlib.decompress(packed), 3 * width, []
    above = bytearray(stride)
    for y in range(height):
        kind, *row = raw[y * (stride + 1) : (y + 1) * (stride + 1)]
        for x in range(stride):
            left, corner = (row[x - 3], above[x - 3]) if x >= 3 else (0, 0)
            row[x] = (row[x] + predicted(kind, left, above[x], corner)) & 255
        above = bytearray(row)
        rows.append(above)
    return width, rows


def write_png(file, rows):
    """Writes rows of red, green and blue."""

    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    header = struct.pack(">IIBBBBB", len(rows[0]) // 3, len(rows), 8, 2, 0, 0, 0)
    packed = zlib.compress(b"".join(b"\0" + row for row in rows), 9)
    file.write_bytes(
        b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", packed) + chunk(b"IEND", b"")
    )


def part_of(rows, part, times):
    """Returns a part of the picture, enlarged without blending."""
    left, top, width, height = part
    out = []
    for row in rows[top : top + height]:
        pixels = [bytes(row[3 * x : 3 * x + 3]) * times for x in range(left, left + width)]
        out += [b"".join(pixels)] * times
    return out


def draw(client, folder, scene, view, size, effect):
    """Returns the rows of a picture with the effect as given."""
    command = [client, "render", root / f"deploy/scenes/{scene}.toml", "--out", folder, "--view", view]
    command += ["--quality", "medium", "--size", f"{size[0]}x{size[1]}", "--effect", effect]
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"effect_pictures: {' '.join(map(str, command))}\n{done.stdout}{done.stderr}")
    return read_png(pathlib.Path(folder) / f"{scene}-{view}.png")[1]


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--client", default=root / "build/release/bin/prosector-client")
    options.add_argument("--out", type=pathlib.Path, default=root / "docs/pictures/scenes")
    chosen = options.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        for effect, scene, view, other, size, part, times in pictures:
            both = [
                part_of(draw(chosen.client, folder, scene, view, size, f"{effect}={state}"), part, times)
                for state in ("on", other)
            ]
            gap = b"\xff" * 12
            write_png(chosen.out / f"effect-{effect}.png", [a + gap + b for a, b in zip(*both)])
            print(f"effect-{effect}.png", flush=True)


if __name__ == "__main__":
    main()
