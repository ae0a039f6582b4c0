"""Blades that move by themselves: on a hub that turns at a speed that is a number or a formula, alone or in a row; free ones that tumble."""

import math

import numpy as np
from entries import set_initial
from liquids import draw_any_bird
from scene import log_uniform, round_figures
from strikes import METALS, aim_bird, draw_blade, set_metal, set_times


def unit(draw):
    vector = np.array([draw.gauss(0., 1.) for _ in range(3)])
    return vector / np.linalg.norm(vector)


def draw_axis(draw, shape):
    """Hubs square to the span with the blade standing on them, or anywhere: (axis, a point on it, m)."""
    if draw.random() < 0.3:
        return unit(draw), shape.length * draw.uniform(0., 2.) * unit(draw)
    across = draw.uniform(0., 2. * math.pi)
    lean = draw.uniform(-0.3, 0.3)
    axis = np.array((math.sin(lean), math.cos(lean) * math.cos(across), math.cos(lean) * math.sin(across)))
    return axis, np.array((-shape.length * log_uniform(draw, 0.05, 3.), 0., 0.))


def borne(info):
    """Pa, that every metal of the blade bears, nearly or wholly elastic."""
    return min(METALS[name][0] * min(METALS[name][2], 1e-2) for name in info["metals"])


def draw_rate(scene, draw, axis, centre):
    """rad/s at which the centrifugal stress of span and bending at the root, roughly, is a drawn share of what the metal bears."""
    info, shape = scene.info, scene.blade.shape
    points = np.array(scene.blade.surface.points) - centre
    outward = points - np.outer(points @ axis, axis)
    pull = outward.mean(axis=0)  # per square of the speed
    stress = shape.length * (abs(pull[0]) + 3. * shape.length / info["thickness"] * np.linalg.norm(pull[1:]))
    density = max(METALS[name][1] for name in info["metals"])
    by_stress = math.sqrt(log_uniform(draw, 1e-4, 0.5) * borne(info) / (density * stress))
    farthest = np.linalg.norm(outward, axis=1).max()
    return round_figures(min(by_stress, 3. * info["speed"] / farthest, 0.5 / info["end_guess"])), farthest


def speed_entry(draw, rate, end):
    """(entry, speed at t = 0): numbers and formulas of either sign, shafts that run down, up from rest, or swing."""
    rate = rate * draw.choice((1., -1.))
    how = draw.choice(("number", "number", "runs down", "runs up", "swings"))
    if how == "runs down":
        return f"{rate!r} - {round_figures(rate * draw.uniform(0.05, 1.) / end)!r}*t", rate
    if how == "runs up":
        return f"{round_figures(rate / end)!r}*t", 0.
    if how == "swings":
        return f"{rate!r}*(1 + {draw.uniform(0.02, 0.5):.3g}*sin({round_figures(draw.uniform(1., 12.) / end)!r}*t))", rate
    return repr(rate), rate


def set_spin(scene, draw, axis, centre, rate):
    speed, at_start = speed_entry(draw, rate, scene.info["end"])
    for entry, value in {"Speed": speed, "Axis": [float(c) for c in axis * draw.choice((1., 0.3, 7.))], "Centre": [float(c) for c in centre],
                         "Prestress": draw.choice(("true", "true", "true", "false"))}.items():
        scene.set("Blade/Spin/" + entry, value)
    return at_start


def see_from_hub(scene, spin, centre):
    """The bird's velocity, drawn as the hub sees it, in fixed axes; it stands off as far as it was meant to."""
    aim = np.array([float(x) for x in scene.settings["Bird/Aim point"].split(",")])
    seen = np.array(scene.info["velocity"])
    fixed = seen + np.cross(spin, aim - centre)
    if np.linalg.norm(fixed) < 0.02 * np.linalg.norm(seen):
        fixed = fixed + 0.1 * seen
    scene.set("Bird/Velocity", [float(v) for v in fixed])
    scene.set("Bird/Stand-off", float(1.5 * scene.info["stand_off"] * np.linalg.norm(fixed) / np.linalg.norm(seen)))


def guess_end(info):
    bird_step = 0.35 * info["spacing"] / (info["sound"] + 1.2 * info["speed"])
    info["end_guess"] = min(1.3 * info["length"] / info["speed"], 300. * bird_step)


def set_steady_pressure(scene, draw):
    """That bends the blade as a part of what its metal bears, besides the spin."""
    info = scene.info
    slender = info["thickness"] / scene.blade.shape.length
    scene.set("Blade/Loads/Pressure", round_figures(0.1 * borne(info) * slender**2 * log_uniform(draw, 1e-3, 1.)))
    if info["kind"] == "solid":
        scene.set("Blade/Loads/Pressure boundaries", draw.choice(("15", "16")))


def turning(scene, draw):
    """Any bird on a blade on a hub, about any axis, some under a steady pressure."""
    draw_any_bird(scene, draw, "Bird", log_uniform(draw, 20., 600.), draw.randint(40, 200))
    info = scene.info
    blade_step = draw_blade(scene, draw, ("shell", "shell", "solid"), ("10", "10", "10", "10, 11"), False, 0.2)
    aim_bird(scene, draw)
    guess_end(info)
    scene.set("Contact/Friction", draw.choice((0., 0., 0.2)))
    set_times(scene, draw, blade_step, len(scene.mesh.cells))
    axis, centre = draw_axis(draw, scene.blade.shape)
    rate, farthest = draw_rate(scene, draw, axis, centre)
    at_start = set_spin(scene, draw, axis, centre, rate)
    see_from_hub(scene, at_start * axis, centre)
    if draw.random() < 0.3:
        set_steady_pressure(scene, draw)
    info.update(turns=True, closing_energy=0.5 * info["mass"] * info["speed"]**2, most_speed=info["speed"] + 4. * abs(rate) * farthest)


def tumbling(scene, draw):
    """Any bird on a free blade that turns about the place where it is struck."""
    draw_any_bird(scene, draw, "Bird", log_uniform(draw, 20., 600.), draw.randint(40, 200))
    info = scene.info
    blade_step = draw_blade(scene, draw, ("shell", "solid"), ("",), False, 0.2)
    aim_bird(scene, draw)
    guess_end(info)
    set_times(scene, draw, blade_step, len(scene.mesh.cells))
    points = np.array(scene.mesh.points)
    aim = np.array([float(x) for x in scene.settings["Bird/Aim point"].split(",")])
    still = points[np.argmin(((points - aim)**2).sum(axis=1))]
    reach = np.linalg.norm(points - still, axis=1).max()
    spin = unit(draw) * min(0.5 * info["speed"] / reach, 0.03 * info["wave"] / reach, 0.5 / info["end_guess"]) * draw.random()
    info.update(free=False, initial_spin=[float(w) for w in spin], initial_velocity=[float(v) for v in -np.cross(spin, still)],
                closing_energy=0.5 * info["mass"] * info["speed"]**2, most_speed=1.5 * info["speed"])
    set_initial(scene)


def draw_places(scene, draw):
    """(number of blades, place of the described one, places of rigid ones)."""
    n = draw.choice((2, 3, 3, 4))
    place = draw.randint(1, n)
    rigid = [k for k in range(1, n + 1) if k != place and draw.random() < draw.choice((0., 0.5))]
    scene.set("Blade/Mesh/Row/Blades", n)
    scene.set("Blade/Mesh/Row/Place", place)
    scene.set("Blade/Mesh/Row/Rigid", " ".join(map(str, rigid)))
    return n, place, rigid


def draw_row_blade(scene, draw):
    """The built-in blade about y, standing at its root radius; its step (s)."""
    info = scene.info
    kind, metal = draw.choice(("shell", "shell", "solid")), draw.choice(("titanium", "aluminium", "weak", "soft"))
    length, chord = (round_figures(info["diameter"] * draw.uniform(*sides)) for sides in ((1.5, 3.), (0.5, 1.5)))
    element = info["spacing"] * log_uniform(draw, 0.7, 4.)
    n_span, n_chord = (max(least, min(most, round(side / element))) for side, least, most in ((length, 3, 14), (chord, 2, 8)))
    thickness = round_figures(min(info["spacing"] * log_uniform(draw, 0.3, 1.5), 2. * min(length / n_span, chord / n_chord)))
    root = round_figures(length * log_uniform(draw, 0.3, 3.))
    stagger = draw.uniform(-45., 45.)
    for path, value in {"Kind": kind, "Mesh/Generator": "blade", "Mesh/Length": length, "Mesh/Chord": chord, "Thickness/Value": thickness,
                        "Mesh/Elements along span": n_span, "Mesh/Elements along chord": n_chord, "Mesh/Profile/Root radius": root,
                        "Mesh/Profile/Stagger": f"{stagger:.4g} + {draw.uniform(-30., 30.):.3g}*s",
                        "Mesh/Profile/Camber": f"{draw.choice((0., draw.uniform(0., 0.1))):.3g}"}.items():
        scene.set("Blade/" + path, value)
    wave = set_metal(scene, draw, "", metal, draw.random() < 0.15)
    can_fail = "Blade/Material/Failure" in scene.settings
    formulation = draw.choice(("physical", "Belytschko-Tsay", "fully integrated") if kind == "shell" else
                              ("one point", "B-bar") if can_fail else ("one point", "B-bar", "solid-shell"))
    scene.set("Blade/Element/Formulation", formulation)
    shortest = min(length / n_span, chord / n_chord, thickness if kind == "solid" else math.inf)
    info.update(kind=kind, metals=[metal], formulation=formulation, thickness=thickness, element=shortest, can_fail=can_fail, free=False,
                length_x=length, chord=chord, root=root, stagger=stagger, cells=n_span * n_chord, young=METALS[metal][0], wave=wave)
    return 0.4 * shortest / wave


def row(scene, draw):
    """A bird on several blades of a row, elastic and rigid ones, that stands or turns."""
    draw_any_bird(scene, draw, "Bird", log_uniform(draw, 30., 400.), draw.randint(80, 250))
    info = scene.info
    blade_step = draw_row_blade(scene, draw)
    n, place, _ = draw_places(scene, draw)
    radius = info["root"] + draw.uniform(0.3, 0.95) * info["length_x"]
    gap = info["diameter"] * draw.uniform(0.3, 1.2)
    least = (2. * info["thickness"] + 0.1 * info["diameter"]) / info["root"] / math.cos(math.radians(75.))  # as the twisted tip stands
    pitch = min(math.degrees(max(gap / radius, least)), 300. / n) * draw.choice((1., -1.))
    scene.set("Blade/Mesh/Row/Pitch", round_figures(pitch))
    guess_end(info)
    info["closing"] = info["speed"]
    set_times(scene, draw, blade_step, n * info["cells"])
    metal, tip = METALS[info["metals"][0]], info["root"] + info["length_x"]
    by_stress = math.sqrt(log_uniform(draw, 1e-3, 0.5) * borne(info) / (metal[1] * tip * info["length_x"]))
    rate = round_figures(min(by_stress, 3. * info["speed"] / tip, 0.5 / info["end_guess"])) if draw.random() < 0.75 else 0.
    axis, centre = np.array((0., 1., 0.)), np.zeros(3)
    at_start = set_spin(scene, draw, axis, centre, rate)
    angle = math.radians(info["stagger"] + draw.choice((1., -1.)) * draw.uniform(10., 90.))  # to the chord, in the plane of chord and normal
    seen = draw.choice((1., -1.)) * np.array((draw.uniform(-0.2, 0.2), math.cos(angle), math.sin(angle)))
    seen = info["speed"] * seen / np.linalg.norm(seen)
    aim = np.array((radius, *(draw.uniform(-0.4, 0.4) * info["chord"] * np.array((1., 0.3)))))
    info["velocity"] = [float(v) for v in seen]
    scene.set("Bird/Aim point", [float(x) for x in aim])
    fixed = seen + np.cross(at_start * axis, aim)
    scene.set("Bird/Velocity", [float(v) for v in fixed])
    info.update(turns=rate > 0., closing_energy=0.5 * info["mass"] * info["speed"]**2, most_speed=info["speed"] + 4. * abs(rate) * tip)


KINDS = {"turning": turning, "tumbling": tumbling, "row": row}
