#!/usr/bin/python3
"""check_figures.py FILE: the example's figures are near what theory says, or within what the scene allows."""
import re
import sys

text = open(sys.argv[1]).read()


def figure(pattern, least, most):
    found = re.search(pattern, text)
    if not found or not least <= float(found[1]) <= most:
        sys.exit(f"{pattern}: expected {least} to {most} in:\n{text}")


# A cantilever of length L under its own weight, Euler-Bernoulli: 3ρgL⁴/2Eh². It is free from about 0.35 m on; its round edges and its tied end give way, too.
bends = 1e3 * 1.5 * 1000 * 9.81 * 0.35**4 / (1e7 * 0.04**2)
figure(r"sags by ([\d.]+) mm", 0.85 * bends, 1.25 * bends)
figure(r"presses with ([\d.]+) N", 0.1, 20)
figure(r"moves by up to ([\d.]+) mm", 3, 25)
