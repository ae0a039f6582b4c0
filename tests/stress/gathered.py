"""Flocks of birds, blades of plies, and blades that are loaded and driven while they are struck."""

import math

import numpy as np
from entries import set_loads, set_plies
from liquids import cut, draw_any_bird
from scene import log_uniform, round_figures
from strikes import aim_bird, draw_blade, set_times
from turning import draw_axis, draw_rate, guess_end, see_from_hub, set_spin, unit

ENTRIES = ("Velocity", "Aim point", "Stand-off", "Roll")


def flock(scene, draw):
    """Two or three birds of different liquids, spacings and starts, whole or slices, on one blade."""
    info, birds = scene.info, []
    for number in range(1, draw.choice((2, 2, 3)) + 1):
        section = "Bird" if number == 1 else f"Bird {number}"
        birds.append((section, draw_any_bird(scene, draw, section, log_uniform(draw, 30., 600.), draw.randint(40, 120))))
    coarsest = max((of for _, of in birds), key=lambda of: of["spacing"])
    info.update(spacing=coarsest["spacing"], diameter=coarsest["diameter"])  # of which elements and thickness are drawn shares
    blade_step = draw_blade(scene, draw, can_scale=False)
    first = {}
    for section, of in reversed(birds):  # the first last, whose figures the scene keeps
        info.update({key: of[key] for key in ("speed", "length", "diameter", "spacing", "sound", "law", "mass")})
        aim_bird(scene, draw)
        of.update(velocity=info["velocity"], closing=info["closing"])
        first[section] = {entry: scene.settings["Bird/" + entry] for entry in ENTRIES}
        of["share"] = cut(scene, draw, section, of) if draw.random() < 0.3 else 1.
    for section, entries in first.items():
        for entry, value in entries.items():
            scene.set(f"{section}/{entry}", value)
    scene.set("Contact/Friction", draw.choice((0., 0., 0.3)))
    set_times(scene, draw, blade_step, len(scene.mesh.cells))
    slowest = min(0.35 * of["spacing"] / (of["sound"] + 1.2 * of["speed"]) for _, of in birds)
    info["end"] = round_figures(min(info["end"], 300. * slowest))
    set_arrivals(scene, draw, birds, first)
    info["end"] = round_figures(min(info["end"], 6e5 / len(scene.mesh.cells) * min(blade_step, slowest)))
    scene.set("Time/End time", info["end"])
    info.update(birds=[section for section, _ in birds], closing_energy=sum(0.5 * of["mass"] * of["share"] * of["speed"]**2 for _, of in birds),
                most_speed=max(of["speed"] for _, of in birds), mass=sum(of["mass"] for _, of in birds),
                speed=max(of["speed"] for _, of in birds), spacing=max(of["spacing"] for _, of in birds), n_birds=len(birds))


def set_arrivals(scene, draw, birds, aims):
    """Later ones come so much later that they are clear of those before; the end waits for them."""
    info, there = scene.info, []
    for section, of in birds:
        aim, velocity = (np.array([float(x) for x in aims[section][entry].split(",")]) for entry in ("Aim point", "Velocity"))
        size = math.hypot(of["length"], of["diameter"]) + 2. * of["spacing"]
        arrival = draw.choice((0., 0., draw.uniform(0., 0.7))) * info["end"]

        def centre():
            return aim - (arrival + 0.5 * of["length"] / of["speed"]) * velocity
        while any(np.linalg.norm(centre() - other) < 0.6 * (size + of_other) for other, of_other in there):
            arrival += 0.1 * size / of["speed"]
        there.append((centre(), size))
        scene.set(section + "/Arrival time", round_figures(arrival))
        info["end"] = round_figures(max(info["end"], min(arrival + 0.5 * of["length"] / of["speed"], 3. * info["end"])))


FIBRES = {  # E1, E2, nu12, G12, G13, G23 (Pa), density; strengths Xt, Xc, Yt, Yc, Sc (Pa)
    "carbon": ((138e9, 9e9, 0.3, 6.9e9, 6.9e9, 3.4e9, 1600.), (2.4e9, 1.5e9, 75e6, 250e6, 100e6)),
    "glass": ((45e9, 12e9, 0.28, 5.5e9, 5.5e9, 4e9, 2000.), (1e9, 0.7e9, 40e6, 140e6, 70e6)),
    "foam": ((1e9, 1e9, 0.3, 0.385e9, 0.385e9, 0.385e9, 200.), (20e6, 20e6, 20e6, 20e6, 12e6)),
    "metal": ((70e9, 70e9, 0.33, 26.3e9, 26.3e9, 26.3e9, 2700.), ()),
}
CONSTANTS = ("Young's modulus 1", "Young's modulus 2", "Poisson's ratio 12", "Shear modulus 12", "Shear modulus 13", "Shear modulus 23",
             "Density")
STRENGTHS = ("Longitudinal tension", "Longitudinal compression", "Transverse tension", "Transverse compression", "Shear strength")


def set_constants(scene, section, name, weaker):
    """Strengths are `weaker` (0: never fails) times the fibre's."""
    constants, strengths = FIBRES[name]
    for entry, value in (*zip(CONSTANTS, constants), *zip(STRENGTHS, (weaker * s for s in strengths if weaker > 0.))):
        scene.set(section + entry, value)


def draw_plies(scene, draw, thickness):
    weaker = draw.choice((0., 0.1, 0.3, 1., 1., 3.))
    kinds = draw.choice((("",), ("",), ("", "second"), ("second", "third")))
    n = draw.choice((1, 2, 3, 4, 8))
    angles = draw.choice(((0.,), (0., 90.), (0., 45., -45., 90.), tuple(round_figures(draw.uniform(-90., 90.)) for _ in range(3))))
    shares = [draw.choice((1., 1., draw.uniform(0.2, 3.))) for _ in range(n)]
    scene.info["plies"] = [(angles[k % len(angles)], float(thickness * share / sum(shares)), kinds[k % len(kinds)])
                           for k, share in enumerate(shares)]
    set_plies(scene)
    names = draw.sample(sorted(FIBRES), 3)
    if "" in kinds[:n]:
        set_constants(scene, "Blade/Laminate/", names[0] if names[0] != "metal" else "carbon", weaker)
    for number, name in enumerate(("second", "third"), 1):
        if name in kinds[:n]:
            section = f"Blade/Laminate/Material {number}/"
            scene.set(section + "Name", name)
            set_constants(scene, section, names[number], weaker)
    for entry, value in {"Reference direction": " ".join(repr(float(c)) for c in unit(draw) + (2., 0., 0.)),
                         "Points per ply": draw.choice((1, 1, 2, 3))}.items():
        scene.set("Blade/Laminate/" + entry, value)
    if weaker > 0.:
        for entry, value in {"Shear weight": draw.choice((0., 1.)), "Degradation time": draw.choice((1e-9, 1e-5, 1e-4, 1e-4)),
                             "Failed share": draw.choice((1., 0.5)), "Smallest step": draw.choice((0., 0.1, 0.3))}.items():
            scene.set("Blade/Laminate/" + entry, value)
    scene.info["can_fail"] = scene.info["can_fail"] or weaker > 0.
    return 11000.  # m/s, no wave of them is faster


def plies(scene, draw):
    """A blade of plies that hold or fail, in part of a metal bonded to it, at rest or on a hub."""
    draw_any_bird(scene, draw, "Bird", log_uniform(draw, 20., 400.), draw.randint(40, 200))
    info = scene.info
    blade_step = draw_blade(scene, draw, ("shell",), can_scale=False, share_that_fails=0.2)
    for path in [p for p in scene.settings if p.startswith("Blade/Material/")]:
        del scene.settings[path]
    wave = max(info["wave"], draw_plies(scene, draw, info["thickness"]))
    blade_step = min(blade_step, 0.4 * info["element"] / wave)
    aim_bird(scene, draw)
    guess_end(info)
    set_times(scene, draw, blade_step, len(scene.mesh.cells))
    info.update(closing_energy=0.5 * info["mass"] * info["speed"]**2, most_speed=info["speed"])
    if scene.settings["Blade/Supports/Clamped"] and draw.random() < 0.3:
        info["metals"] = info["metals"] + ["aluminium"]
        axis, centre = draw_axis(draw, scene.blade.shape)
        rate, farthest = draw_rate(scene, draw, axis, centre)
        at_start = set_spin(scene, draw, axis, centre, rate)
        see_from_hub(scene, at_start * axis, centre)
        info.update(turns=True, free=False, most_speed=info["speed"] + 4. * abs(rate) * farthest)


def draw_point_loads(scene, draw, force, end):
    """One or two, on inner points; of bricks without moments."""
    info, loads = scene.info, []
    for _ in range(draw.choice((0, 1, 1, 2))):
        place = scene.mesh.points[draw.randrange(len(scene.mesh.points))]
        moment = unit(draw) * force * info["thickness"] * draw.choice((0., 1.)) * (info["kind"] == "shell")
        loads.append((list(place), [float(c) for c in force * unit(draw)], [float(c) for c in moment],
                      draw.choice(("1", f"t/{end!r}", f"1 - t/{end!r}"))))
    info["point_loads"] = loads


def loaded(scene, draw):
    """Pressure, point loads, driven supports and damping on a blade that is struck meanwhile."""
    draw_any_bird(scene, draw, "Bird", log_uniform(draw, 20., 400.), draw.randint(40, 200))
    info = scene.info
    blade_step = draw_blade(scene, draw, ("shell", "shell", "solid"), ("10", "10, 11", "10", ""), False, 0.)
    aim_bird(scene, draw)
    set_times(scene, draw, blade_step, len(scene.mesh.cells))
    shape, end = scene.blade.shape, info["end"]
    weight = info["mass"] * info["speed"]**2 / info["length"]  # N, of the bird's mean push
    draw_point_loads(scene, draw, weight * log_uniform(draw, 1e-3, 0.3), end)
    info["driven"] = []
    held = scene.settings["Blade/Supports/Clamped"]
    if held and draw.random() < 0.6:
        side = draw.choice(("12", "13", "11" if "11" not in held else "12"))
        way = unit(draw) * shape.length * log_uniform(draw, 1e-4, 1e-2)
        info["driven"] = [(side, [float(c) for c in way], draw.choice((f"t/{end!r}", f"sin({4. / end!r}*t)", f"(t/{end!r})^2")))]
    set_loads(scene)
    if draw.random() < 0.6:
        pressure = round_figures(weight / (shape.length * shape.chord) * log_uniform(draw, 1e-3, 0.3))
        scene.set("Blade/Loads/Pressure", f"{pressure!r}*{draw.choice(('1', f'exp(-{3. / end!r}*t)', f'cos({9. / end!r}*t)'))}")
        scene.set("Blade/Loads/Pressure boundaries", draw.choice(("15", "16")))
        if info["kind"] == "shell":
            del scene.settings["Blade/Loads/Pressure boundaries"]
    if not info["driven"] and draw.random() < 0.3:
        scene.set("Blade/Loads/Damping", round_figures(draw.uniform(0.01, 1.) / end))
    info.update(free=False, closing_energy=0.5 * info["mass"] * info["speed"]**2, pushed=True, most_speed=math.inf)


KINDS = {"flock": flock, "plies": plies, "loaded": loaded}
