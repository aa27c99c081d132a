# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
"""The reliability diagram that docs/make_tables draws from reliability_bins.csv, as SVG."""
import math

LEAST, MOST = 1e-4, 1.0  # of both axes
SIDE, LEFT, TOP = 420, 90, 54  # [px]
BLUE, GREY, BLACK = "#0072b2", "#8a919c", "#22262e"


def at(share):
    """How far along an axis, 0 to 1."""
    share = min(max(share, LEAST), MOST)
    return math.log(share / LEAST) / math.log(MOST / LEAST)


def point(told, wrong):
    return LEFT + SIDE * at(told), TOP + SIDE * (1.0 - at(wrong))


def wilson(bad, scans):
    """The interval that holds a share with 95 %, where `bad` of so many scans were seen (Wilson 1927)."""
    z, p = 1.96, bad / scans
    middle = p + z * z / (2 * scans)
    half = z * math.sqrt(p * (1 - p) / scans + z * z / (4 * scans * scans))
    return tuple((middle + sign * half) / (1 + z * z / scans) for sign in (-1, 1))


def text(x, y, words, anchor="middle", color=BLACK, size=15, turn=""):
    return (f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" fill="{color}" '
            f'font-size="{size}"{turn}>{words}</text>')


def line(x1, y1, x2, y2, color=GREY, width=1, dash=""):
    return (f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" stroke="{color}" '
            f'stroke-width="{width}"{dash}/>')


def axes():
    parts = [f'<rect x="{LEFT}" y="{TOP}" width="{SIDE}" height="{SIDE}" fill="none" stroke="{GREY}"/>']
    for power in range(-4, 1):
        x, y = point(10.0**power, 10.0**power)
        label = f"{10.0**power:g}" if power > -4 else "0.0001"
        parts += [line(x, TOP, x, TOP + SIDE, "#dfe3e8"), line(LEFT, y, LEFT + SIDE, y, "#dfe3e8"),
                  text(x, TOP + SIDE + 24, label), text(LEFT - 10, y + 5, label, "end")]
    middle = TOP + SIDE / 2
    parts += [line(*point(LEAST, LEAST), *point(MOST, MOST), BLACK, 1.5, ' stroke-dasharray="6 5"'),
              text(LEFT + SIDE / 2, TOP + SIDE + 52, "probability of being wrong that was told"),
              text(26, middle, "share that was wrong", turn=f' transform="rotate(-90 26 {middle})"'),
              text(LEFT + 14, TOP + 26, "wrong more often than told", "start", GREY),
              text(LEFT + SIDE - 14, TOP + SIDE - 16, "more doubt than needed", "end", GREY)]
    return parts


def svg(bins, weight):
    """@param bins told on average, scans, wrong ones of these; @param weight of a wrong one."""

    def weighed(share):
        return weight * share / (1.0 - share + weight * share)

    width, height = LEFT + SIDE + 40, TOP + SIDE + 76
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
             f'viewBox="0 0 {width} {height}" font-family="sans-serif">',
             f'<rect width="{width}" height="{height}" fill="white"/>',
             text(LEFT, 32, "What is told, and what is so", "start", size=19), *axes()]
    for told, scans, bad in bins:
        if scans == 0:
            continue
        low, high = (weighed(share) for share in wilson(bad, scans))
        x, y = point(told, weighed(bad / scans))
        parts.append(line(x, point(told, low)[1], x, point(told, high)[1], BLUE, 2))
        if bad:
            parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="6" fill="{BLUE}"/>')
        aside = 11 if x < LEFT + SIDE - 60 else -11
        parts.append(text(x + aside, (y if bad else point(told, high)[1]) + 5, f"{scans:,}",
                          "start" if aside > 0 else "end", BLUE, 12))
    return "\n".join([*parts, "</svg>", ""])
