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
