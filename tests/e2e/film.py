"""The pictures of films."""

import io
import pathlib
import sys

from PIL import Image

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent.parent / "deploy"))

from picture_files import jpegs_of


def pictures(film):
    """Those of a film of JPEGs (.avi)."""
    return [Image.open(io.BytesIO(jpeg)).convert("RGB") for jpeg in jpegs_of(film)]


def mjpeg_of_many_sizes(count=30):
    """JPEGs in a row, as a camera's MJPEG stream is, each of another size than the one before."""
    stream = io.BytesIO()
    for k in range(count):
        Image.new("RGB", (64 + 16 * (k % 5), 48 + 8 * (k % 3)), (8 * k, 90, 160)).save(stream, "JPEG")
    return stream.getvalue()
