"""Strikes on blades of any shape: what a scene of the kind 'strike' is drawn from."""

import math

import numpy as np
from blades import Blade, Shape
from draws import LIQUIDS, draw_bird
from scene import log_uniform, round_figures

METALS = {  # name: (Young's modulus Pa, density kg/m3, yield stress / modulus, hardening modulus / modulus, failure strains)
    "titanium": (1.1e11, 4430., 8e-3, 0.01, (0.05, 0.2)),
    "aluminium": (7e10, 2700., 4e-3, 0.01, (0.05, 0.2)),
    "soft": (1e8, 1200., 2e-2, 0.1, (0.3, 0.5)),
    "weak": (7e10, 2700., 3e-4, 0.002, (0.1, 0.3)),
    "brittle": (2e11, 7800., 2e-2, 0.05, (1e-3, 1e-2)),
    "stiff": (5e11, 15000., 5e-3, 0.01, (0.02, 0.1)),
}
PLACES = {"centre": (0.5, 0.), "leading edge": (0.6, -0.5), "trailing edge": (0.6, 0.5), "tip": (1., 0.), "corner": (1., -0.5),
          "root": (0.05, 0.), "root corner": (0.05, 0.5)}


def set_metal(scene, draw, section, name, can_fail):
    young, density, flow, hardening, strains = METALS[name]
    law = draw.choice(("elastic", "linear", "linear", "perfect")) if not can_fail else "linear"
    entries = {"Name": "custom", "Density": density, "Young's modulus": young, "Poisson's ratio": draw.choice((0., 0.3, 0.3, 0.45)),
               "Hardening": law}
    if law != "elastic":
        entries["Yield stress"] = round_figures(flow * young)
    if law == "linear":
        entries["Hardening modulus"] = round_figures(hardening * young)
    if can_fail:
        entries.update({"Failure": "plastic strain", "Failure strain": draw.choice(strains)})
    for entry, value in entries.items():
        scene.set(f"Blade/{section}Material/{entry}", value)
    return math.sqrt(young / density)


def draw_shape(scene, draw, size):
    """Span and chord against the bird's diameter `size`, some narrower than it."""
    length, chord = size * log_uniform(draw, 1., 4.), size * log_uniform(draw, 0.4, 3.)
    return Shape(length, chord, skew=draw.choice((0., 0., math.radians(draw.uniform(-60., 60.)))),
                 camber=draw.choice((0., 0., math.radians(draw.uniform(10., 150.)))),
                 twist=draw.choice((0., 0., math.radians(draw.uniform(-60., 60.)))), taper=draw.choice((0., 0., 0.4)))


def draw_counts(draw, shape, element, most):
    """Elements along span and chord about `element` (m) long across, their aspect ratio up to 20, at most `most` of them."""
    aspect = draw.choice((1., 1., 1., log_uniform(draw, 0.05, 20.)))
    counts = [shape.length / element / math.sqrt(aspect), shape.chord / element * math.sqrt(aspect)]
    shrink = min(1., math.sqrt(most / max(1., counts[0] * counts[1])))
    return [max(1, round(shrink * n)) for n in counts]


def draw_blade(scene, draw, kinds=("shell", "shell", "solid", "solid", "rigid"), supports=("10", "10", "10, 11", "10, 11, 12, 13", ""),
               can_scale=True, share_that_fails=0.3):
    """A blade of one of the kinds, held at one of the choices of boundaries; its step (s)."""
    info = scene.info
    kind = draw.choice(kinds)
    shape = draw_shape(scene, draw, info["diameter"])
    n_span, n_chord = draw_counts(draw, shape, info["spacing"] * log_uniform(draw, 0.2, 10.), 400 if kind != "solid" else 150)
    n_span = max(n_span, 2)
    thickness = round_figures(draw.choice((info["spacing"] * log_uniform(draw, 0.2, 3.), shape.length * log_uniform(draw, 1e-3, 0.3))))
    layers = draw.choice((1, 1, 2, 3)) if kind == "solid" else 0
    if kind == "solid":
        thickness = max(thickness, 0.2 * info["spacing"])  # a thinner one's steps would cost a minute
    straight = draw.random() < 0.5
    cut = draw.uniform(0.2, 0.8)
    second = draw.choice((None, None, lambda s, c: c < cut, lambda s, c: s > cut)) if kind != "rigid" else None
    blade = Blade(shape, n_span, n_chord, thickness, layers, warp=0. if straight else draw.uniform(0., 0.2),
                  jitter=0. if straight else draw.uniform(0., 0.25), second_metal=second, draw=draw)
    if kind == "shell":  # thicker than twice their side, shells are none: the program warns, bricks are for that
        blade.thickness = thickness = min(thickness, round_figures(2. * blade.shortest_side()))
    scene.blade, scene.mesh = blade, blade.mesh
    can_fail = draw.random() < share_that_fails and kind != "rigid"
    for path, value in {"Kind": kind, "Mesh/Generator": "file", "Supports/Tip": "11"}.items():
        scene.set("Blade/" + path, value)
    formulation = {"shell": draw.choice(("physical", "Belytschko-Tsay", "fully integrated")), "rigid": "",
                   "solid": draw.choice(("one point", "B-bar") if can_fail else ("one point", "B-bar", "solid-shell"))}[kind]
    info.update(thickness=thickness, formulation=formulation or "rigid", element=blade.shortest_side(), kind=kind, can_fail=can_fail)
    if kind == "rigid":
        scene.set("Blade/Rigid/Surface", "mesh")
        scene.set("Blade/Rigid/Half thickness", draw.choice((0., round_figures(0.5 * info["spacing"]))))
        scene.set("Blade/Supports/Tip", "")
        scene.set("Blade/Supports/Clamped", "")
        info.update(free=False, young=math.inf)
        return math.inf
    scene.set("Blade/Element/Formulation", formulation)
    if kind == "shell":
        scene.set("Blade/Thickness/Value", thickness)
        scene.set("Blade/Element/Points through thickness", draw.choice((3, 5, 7)))
    elif can_scale and layers > 1 and not can_fail and draw.random() < 0.3:
        scene.set("Blade/Mass scaling/Method", "selective")
        scene.set("Blade/Mass scaling/Largest added inertia", draw.choice((0.01, 1.)))
    names = [draw.choice(sorted(METALS)) for _ in range(2)]
    waves = [set_metal(scene, draw, "", names[0], can_fail)]
    if 2 in blade.mesh.materials:
        scene.set("Blade/Section 1/Material ids", "2")
        waves.append(set_metal(scene, draw, "Section 1/", names[1], can_fail))
    clamped = draw.choice(supports)
    scene.set("Blade/Supports/Clamped" if clamped else "Blade/Supports/Free", clamped or "10, 11, 12, 13")
    if clamped:
        scene.set("Blade/Supports/Tip", "" if "11" in clamped else "11")
    else:
        scene.set("Blade/Supports/Clamped", "")
    info.update(free=not clamped, young=min(METALS[name][0] for name in names[:len(waves)]), wave=max(waves), metals=names[:len(waves)])
    return 0.4 * info["element"] / max(waves)


def aim_bird(scene, draw):
    """At a place of the blade, from either side, at 5 to 90 degrees between velocity and surface."""
    info, shape = scene.info, scene.blade.shape
    place = draw.choice(sorted(PLACES))
    # No particle flies exactly towards a line of the mesh or an edge: round-off would say on which side of it.
    s, c = (x + 0.03 * draw.uniform(-1., 1.) for x in PLACES[place])
    scene.set("Bird/Roll", round_figures(draw.uniform(0., 90.)))
    along, across, normal = shape.tangents(s, c)
    angle, turn = math.radians(draw.choice((90., draw.uniform(5., 90.)))), draw.uniform(0., 2. * math.pi)
    direction = math.cos(angle) * (math.cos(turn) * along + math.sin(turn) * across) + draw.choice((1., -1.)) * math.sin(angle) * normal
    scene.set("Bird/Velocity", [float(info["speed"] * x) for x in direction])
    scene.set("Bird/Aim point", [float(x) for x in shape.point(s, c)])
    info["velocity"] = [float(info["speed"] * x) for x in direction]
    size = float(np.linalg.norm(np.array(scene.blade.surface.points) - shape.point(s, c), axis=1).max())
    info["stand_off"] = round_figures(info["length"] + info["diameter"] + size)
    scene.set("Bird/Stand-off", info["stand_off"])
    info.update(place=place, angle=math.degrees(angle), closing=info["speed"] * max(0.3, math.sin(angle)))


def set_times(scene, draw, blade_step, n_cells):
    """To the bird's end, but no longer than about 300 steps of the bird, or what a million steps of elements cost."""
    info = scene.info
    bird_step = 0.35 * info["spacing"] / (info["sound"] + 1.2 * info["speed"])
    end = min(1.3 * info["length"] / info["closing"], 300. * bird_step, 6e5 / n_cells * min(blade_step, bird_step))
    info["end"] = round_figures(max(end, 15. * bird_step))
    for path, value in {"End time": info["end"], "Bird phase tolerance": 0., "Multirate": draw.choice(("true", "true", "false")),
                        "Maximum ratio": draw.choice((50, 50, 3, 1000))}.items():
        scene.set("Time/" + path, value)
    scene.set("Output/History interval", 0.)


def strike(scene, draw):
    """Any bird on any blade, at any place of it, from anywhere."""
    draw_bird(scene, draw, log_uniform(draw, 10., 1000.), n=draw.randint(40, 250))
    if scene.settings["Bird/Formulation"] == "standard":
        scene.set("Bird/Density by", draw.choice(("continuity", "summation")))
    else:
        correction = draw.choice(("true", "true", "false"))
        scene.set("Bird/Gradient correction", correction)
        scene.set("Bird/Reconstruction", draw.choice(("none", "none", "linear")) if correction == "true" else "none")
        scene.set("Bird/Pair precision", draw.choice(("float", "float", "double")))
    blade_step = draw_blade(scene, draw)
    aim_bird(scene, draw)
    scene.set("Contact/Friction", draw.choice((0., 0., 0., 0.2, 0.5)))
    set_times(scene, draw, blade_step, len(scene.mesh.cells))
