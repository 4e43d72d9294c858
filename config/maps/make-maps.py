#!/usr/bin/env python3
"""Makes the maps beside it: beach-ball.png (a key map), weave.png (a luminance map), orange-peel.png (a height map).

Python's standard library only; the same files on every run. Gray 8-bit PNGs, power-of-two sides.
"""
import math
import pathlib
import random
import struct
import zlib


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def write_gray(name, width, height, value):
    """value(x, y) gives 0 .. 255; row 0 is the top."""
    rows = b"".join(b"\0" + bytes(value(x, y) for x in range(width)) for y in range(height))
    header = struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)
    png = b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b"")
    (pathlib.Path(__file__).parent / name).write_bytes(png)


def beach_ball(x, y):
    """Keys 1 .. 8, one for each gore; two caps at the poles in key 1."""
    if y < 8 or y >= 120:
        return 1
    return x // 32 + 1


def weave(x, y):
    """Plain weave: 16 threads each way, round in section, over and under by turns."""
    u, v = x % 16 / 16, y % 16 / 16
    warp_above = (x // 16 + y // 16) % 2 == 0
    across, along = (u, v) if warp_above else (v, u)
    height = math.sin(math.pi * (across + 1 / 32)) * (0.6 + 0.4 * math.sin(math.pi * (along + 1 / 32)))
    return round(255 * (0.35 + 0.65 * height))


def orange_peel_pits():
    rng = random.Random(84)
    return [(rng.random() * 256, rng.random() * 128, rng.uniform(2.0, 3.6)) for _ in range(900)]


def orange_peel(pits):
    """Pits in a smooth skin; wraps around in x, so that no seam shows on a globe."""
    depth = [[0.0] * 256 for _ in range(128)]
    for px, py, radius in pits:
        for y in range(max(0, int(py - 3 * radius)), min(128, int(py + 3 * radius) + 1)):
            for dx in range(-int(3 * radius), int(3 * radius) + 1):
                x = (int(px) + dx) % 256
                distance = math.hypot(int(px) + dx - px, y - py)
                pit = math.exp(-((distance / radius) ** 2))
                depth[y][x] = max(depth[y][x], pit)
    return lambda x, y: round(255 * (1 - depth[y][x]))


write_gray("beach-ball.png", 256, 128, beach_ball)
write_gray("weave.png", 256, 256, weave)
write_gray("orange-peel.png", 256, 128, orange_peel(orange_peel_pits()))
