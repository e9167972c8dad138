"""Where fetched anatomy lies, and places on it."""

import os
import pathlib

ON_LIVER = [-0.085, 1.04, 0.02]  # m: in cut.toml, on the left lobe's upper side


def anatomy(name):
    return pathlib.Path(os.environ.get("XDG_DATA_HOME", pathlib.Path.home() / ".local/share")) / "prosector" / name
