"""Birds of any liquid, with strength or none, whole or a slice, in any of the sections Bird to Bird 4."""

import math

from draws import LIQUIDS, draw_bird
from scene import Scene, log_uniform, round_figures

LAWS = ("linear", "murnaghan", "murnaghan", "polynomial", "us-up", "porous", "porous", "tabulated")


# What a section does not give it would have from section Bird.
AS_DEFAULT = {"Reconstruction": "none", "Pair precision": "float", "Density by": "continuity", "Equation of state/Pressure table": "",
              "Equation of state/Porosity": "0.1", "Strength/Shear modulus": "0", "Strength/Yield stress": "0", "Slice/Between": "",
              "Slice/Normal": ""}


def table_of(density, sound):
    """Points of p = rho0 c0^2 mu (1 + 2 mu) to mu = 2, beyond the shocks of 1500 m/s."""
    return "; ".join(f"{mu:g}: {density * sound**2 * mu * (1. + 2. * mu):.6g}" for mu in (0., 0.01, 0.03, 0.1, 0.2, 0.4, 0.7, 1.2, 2.))


def set_liquid(scene, draw, section):
    law, density = draw.choice(LAWS), float(scene.settings[section + "/Density"])
    sound = LIQUIDS.get(law, 1483.)
    scene.set(section + "/Equation of state/Type", law)
    if law == "porous":
        scene.set(section + "/Equation of state/Porosity", draw.choice((0., 0.02, 0.1, 0.4)))
    if law == "tabulated":
        sound = round_figures(log_uniform(draw, 300., 2000.))
        scene.set(section + "/Equation of state/Pressure table", table_of(density, sound))
    if scene.settings[section + "/Formulation"] == "riemann" and draw.random() < 0.3:  # the other has no velocity gradients
        shear = round_figures(density * sound**2 * log_uniform(draw, 1e-4, 1e-1))
        scene.set(section + "/Strength/Shear modulus", shear)
        scene.set(section + "/Strength/Yield stress", round_figures(shear * log_uniform(draw, 1e-2, 1.)))
        sound = math.sqrt(sound**2 + 4. / 3. * shear / density)
    return law, sound


def cut(scene, draw, section, info):
    """A slice of it, across its axis or inclined; returns its share of the mass, roughly."""
    half = 0.5 * info["length"]
    low = draw.uniform(-1., 0.4) * half
    high = min(low + draw.uniform(0.4, 1.2) * half, half)
    if high - low < 2.2 * info["spacing"]:
        return 1.
    scene.set(section + "/Slice/Between", (round_figures(low), round_figures(high)))
    if draw.random() < 0.5:
        axis = info["velocity"]
        size = math.hypot(*axis)
        scene.set(section + "/Slice/Normal", [c / size + draw.uniform(-0.4, 0.4) for c in axis])
    return (high - low) / info["length"]


def draw_any_bird(scene, draw, section, speed, n):
    """Of any liquid and formulation, all entries given; figures to scene.info of the first, all returned."""
    alone = Scene(scene.kind, scene.seed)
    for entry, value in AS_DEFAULT.items():
        alone.set("Bird/" + entry, value)
    draw_bird(alone, draw, speed, n=n)
    if alone.settings["Bird/Formulation"] == "riemann":
        alone.set("Bird/Reconstruction", draw.choice(("none", "none", "linear")))
        alone.set("Bird/Pair precision", draw.choice(("float", "float", "double")))
    else:
        alone.set("Bird/Density by", draw.choice(("continuity", "summation")))
    alone.info["law"], alone.info["sound"] = set_liquid(alone, draw, "Bird")
    alone.set("Bird/Roll", round_figures(draw.uniform(0., 90.)))
    for path, value in alone.settings.items():
        scene.set(section + path[len("Bird"):], value)
    if section == "Bird":
        scene.info.update(alone.info)
    else:
        scene.set(section + "/Enabled", "true")
    return alone.info
