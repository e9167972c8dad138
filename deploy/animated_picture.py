#!/usr/bin/python3
"""animated_picture.py FILM.avi PICTURE.webp WIDTH HEIGHT RATE: makes an animated picture of a film of JPEGs of 12 pictures a second, RATE
pictures a second (a divisor of 12). Needs Debian's python3-pil."""

import io
import pathlib
import sys

from PIL import Image

from picture_files import jpegs_of

FILMED = 12  # pictures a second, as deploy/demo_film.sh records


def write_animation(pictures, file, size, rate, quality=60):
    """Writes PIL pictures as one animated WebP of that size (pixels) and rate (1/s); fails above 1 MB."""
    shown = [picture.convert("RGB").resize(size, Image.LANCZOS) for picture in pictures]
    shown[0].save(file, save_all=True, append_images=shown[1:], duration=1000 // rate, loop=0, quality=quality, method=6)
    size = pathlib.Path(file).stat().st_size
    print(f"{file}: {len(shown)} pictures, {size // 1000} kB")
    if size > 1_000_000:
        sys.exit(f"{file}: larger than 1 MB")


if __name__ == "__main__":
    film, picture, width, height, rate = pathlib.Path(sys.argv[1]), sys.argv[2], *map(int, sys.argv[3:6])
    write_animation([Image.open(io.BytesIO(jpeg)) for jpeg in jpegs_of(film)][::FILMED // rate], picture, (width, height), rate)
