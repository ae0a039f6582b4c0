#!/usr/bin/env python3
"""The study of a soft body's pressure: its closed forms, and one coarse flat face. Usage: soft_body_pressure_test.py PROGRAM"""

import math
import os
import sys
import tempfile

import soft_body_pressure as study


def near(a, b, tolerance):
    assert abs(a - b) <= tolerance * abs(b), (a, b)


p_h, shock, c1 = study.hugoniot()
near(p_h, 240.757e6, 1e-5)  # tests/data/hugoniot.csv, Murnaghan at 177.4 m/s
near(shock, 1428.57, 1e-5)
near(c1, 1647.09, 1e-5)
near(study.diameter("cylinder"), 0.0406857, 1e-5)
near(study.diameter("sphere"), (6. * study.MASS / (math.pi * study.DENSITY)) ** (1. / 3.), 1e-12)
radii = [0.1, 0.3, 0.5, 0.7, 0.9]
near(study.fit_decay(radii, [p_h * math.exp(-1.7 * r) for r in radii], p_h), 1.7, 1e-12)
for spacing in study.SPACINGS:
    radius = study.snap(0.004, spacing)
    n = int(radius / spacing) + 2
    rows = sum(math.hypot(i + 0.5, j + 0.5) * spacing < radius for i in range(-n, n) for j in range(-n, n))
    near(rows * spacing ** 2, math.pi * radius ** 2, 1e-12)

with tempfile.TemporaryDirectory() as folder:
    ladder, _ = study.converge(os.path.abspath(sys.argv[1]), folder, 1, p_h, c1, (0.002,))
    # 0.985 and 1.24: the plateau within the 2.5 % of the shock on a wall, the ring of first touch within a tenth
    near(ladder[0]["plateau"], 1., 0.025)
    near(ladder[0]["peak"], 1.24, 0.1)
print(f"plateau {ladder[0]['plateau']:.3f}, first peak {ladder[0]['peak']:.2f} of the Hugoniot pressure")
