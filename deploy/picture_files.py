"""Reads, writes and puts together pictures for the documentation; what scripts that draw them share."""
import pathlib
import struct
import subprocess
import sys
import zlib

root = pathlib.Path(__file__).resolve().parent.parent


def predicted(kind, left, above, corner):
    """Returns what a byte of a PNG's row is counted from, by the row's filter."""
    if kind == 4:  # Paeth
        estimate = left + above - corner
        return min((left, above, corner), key=lambda value: abs(estimate - value))
    return (0, left, above, (left + above) // 2)[kind]


def read_png(file):
    """Returns the rows of a picture of 8 bits each of red, green and blue."""
    return rows_of(pathlib.Path(file).read_bytes(), file)


def rows_of(data, file):
    """Returns the rows of a PNG's bytes; `file` is what a complaint calls it."""
    place, packed = 8, b""
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
    return rows


def filtered(kind, row, above):
    """Returns a row as a PNG keeps it: less what the filter predicts."""
    out = bytearray(row)
    for x in range(len(row)):
        left, corner = (row[x - 3], above[x - 3]) if x >= 3 else (0, 0)
        out[x] = (row[x] - predicted(kind, left, above[x], corner)) & 255
    return bytes([kind]) + out


def write_png(file, rows):
    """Writes rows of red, green and blue."""

    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    header = struct.pack(">IIBBBBB", len(rows[0]) // 3, len(rows), 8, 2, 0, 0, 0)
    kept, above = [], bytes(len(rows[0]))
    for row in rows:
        kept.append(filtered(4, row, above))
        above = row
    packed = zlib.compress(b"".join(kept), 9)
    file.write_bytes(
        b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", packed) + chunk(b"IEND", b"")
    )


def jpegs_of(film):
    """Yields the bytes of each picture of a film of JPEGs (.avi)."""
    data = pathlib.Path(film).read_bytes()
    at = data.index(b"movi") + 4
    while data[at : at + 2] == b"00":
        size = struct.unpack("<I", data[at + 4 : at + 8])[0]
        yield data[at + 8 : at + 8 + size]
        at += 8 + size + size % 2


def part_of(rows, part, times):
    """Returns a part of the picture, enlarged without blending."""
    left, top, width, height = part
    out = []
    for row in rows[top : top + height]:
        pixels = [bytes(row[3 * x : 3 * x + 3]) * times for x in range(left, left + width)]
        out += [b"".join(pixels)] * times
    return out


def shrunk(rows, width, height):
    """Returns the picture in a smaller size, each pixel the mean of those that it covers."""
    across, down, out = len(rows[0]) // 3 / width, len(rows) / height, []
    for y in range(height):
        lines = rows[int(y * down) : max(int((y + 1) * down), int(y * down) + 1)]
        row = bytearray()
        for x in range(width):
            first, last = int(x * across), max(int((x + 1) * across), int(x * across) + 1)
            for channel in range(3):
                values = [line[3 * k + channel] for line in lines for k in range(first, last)]
                row.append(round(sum(values) / len(values)))
        out.append(bytes(row))
    return out


def beside(pictures, gap=4):
    """Returns pictures of one height side by side, with a white gap of so many pixels."""
    return [(b"\xff" * 3 * gap).join(bytes(row) for row in rows) for rows in zip(*pictures)]


def below(pictures, gap=4):
    """Returns pictures of one width one below the other, with a white gap of so many pixels."""
    white = [b"\xff" * len(pictures[0][0])] * gap
    return sum((white + picture for picture in pictures[1:]), list(pictures[0]))


def draw(client, folder, scene, view, *options, size=(640, 480)):
    """Draws a shipped scene from a view without a server. Returns the rows of the picture."""
    command = [client, "render", root / f"deploy/scenes/{scene}.toml", "--out", folder, "--view", view]
    command += ["--size", f"{size[0]}x{size[1]}", *options]
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}")
    return read_png(pathlib.Path(folder) / f"{scene}-{view}.png")
