"""What both eyes of a headset see of minimal.toml's red ball, and where it should be in their pictures."""

import math

from checks import check

HEAD = (0.05, 1.3, 0.45)
TURN = (0.9483237, -0.3173047, 0, 0)  # of the head: w, x, y, z; it looks down
PITCH = 2 * math.atan2(TURN[1], TURN[0])
FOV = {"left": (-0.85, 0.70, 0.72, -0.80, -0.032), "right": (-0.70, 0.85, 0.72, -0.80, 0.032)}  # left, right, up, down, rad; aside, m


def expected(eye, ball, size, fov):
    """Where that place is in the eye's picture, pixels from the upper left."""
    left, right, up, down, aside = fov[eye]
    x, y, z = (ball[k] - HEAD[k] for k in range(3))
    y, z = y * math.cos(PITCH) + z * math.sin(PITCH), -y * math.sin(PITCH) + z * math.cos(PITCH)
    across, high = (x - aside) / -z, y / -z
    part = lambda value, low, most: (value - math.tan(low)) / (math.tan(most) - math.tan(low))
    return size[0] * part(across, left, right), size[1] * (1 - part(high, down, up))


def seen(image):
    """Where red is in the eye's picture, its middle, and how bright the picture is."""
    width, height = image.size
    red = [(k % width + 0.5, k // width + 0.5) for k, (r, g, b) in enumerate(image.getdata()) if r > 60 and r > g + 25]
    middle = [sum(place[axis] for place in red) / max(1, len(red)) for axis in (0, 1)]
    return middle, len(red), sum(image.convert("L").getdata()) / (width * height)


def look(images, ball, fov=FOV):
    """Checks what both eyes see of the ball, whose middle is at that place; `images` and `fov` by eye."""
    middles = {}
    size = images["left"].size
    for eye, image in images.items():
        middles[eye], count, brightness = seen(image)
        at = expected(eye, ball, size, fov)
        print(f"{eye}: ball of {count} pixels at ({middles[eye][0]:.1f}, {middles[eye][1]:.1f}), expected at ({at[0]:.1f}, {at[1]:.1f}); "
              f"brightness {brightness:.1f}")
        check(f"the {eye} eye's picture isn't black", brightness > 10 and count > 200)
        check("the ball is where it should be", math.dist(middles[eye], at) < 4)
    disparity = middles["left"][0] - middles["right"][0]
    wanted = expected("left", ball, size, fov)[0] - expected("right", ball, size, fov)[0]
    print(f"disparity {disparity:.2f} pixels, expected {wanted:.2f}")
    check("disparity is as expected", abs(disparity - wanted) < 1.5)
