"""Random scenes of special kinds, on built-in plates for the most part. All random numbers come from the seed."""

import math

import meshes
from scene import log_uniform, round_figures

# (rho0 c0^2 over rho0)^(1/2) and more is the program's; here only what a time step is guessed by (m/s)
LIQUIDS = {"linear": 1522., "murnaghan": 1037., "polynomial": 1473., "us-up": 1483.}
SHELLS = ("physical", "Belytschko-Tsay", "fully integrated")
BRICKS = ("one point", "solid-shell", "B-bar")


def draw_bird(scene, draw, speed, direction=(0., 0., 1.), n=None):
    """A bird of some hundred particles; its diameter D, spacing and velocity go to `info`."""
    spacing = round_figures(log_uniform(draw, 2e-3, 8e-3))
    n = n or draw.randint(100, 400)
    density = draw.choice((950., 950., 1000., 600.))
    law = draw.choice(sorted(LIQUIDS))
    mass = round_figures(n * density * spacing**3)
    shape = draw.choice(("cylinder", "cylinder", "hemispherical cylinder", "ellipsoid", "sphere"))
    slenderness = {"sphere": 1.}.get(shape, draw.choice((1.5, 2.)))
    diameter = (mass / density * 4. / math.pi / slenderness)**(1. / 3.) * {"cylinder": 1., "sphere": 1.145}.get(shape, 1.1)
    velocity = [round_figures(speed * c) for c in direction]
    for path, value in {"Mass": mass, "Density": density, "Particle spacing": spacing, "Shape": shape, "Velocity": velocity,
                        "Length over diameter": slenderness, "Retire": "false", "Equation of state/Type": law,
                        "Packing": draw.choice(("cubic", "cubic", "fcc")),
                        "Formulation": draw.choice(("riemann", "riemann", "riemann", "standard"))}.items():
        scene.set("Bird/" + path, value)
    scene.info.update(mass=mass, spacing=spacing, diameter=diameter, length=slenderness * diameter, speed=speed, velocity=velocity,
                      law=law, sound=LIQUIDS[law])


def set_end(scene, blade_step, steps=600):
    """To the bird's end, but no longer than a few seconds of work."""
    info = scene.info
    bird_step = 0.4 * info["spacing"] / (info["sound"] + 1.2 * info["speed"])
    across = max(abs(info.get("closing", info["speed"])), 1e-9)
    end = min(1.2 * info["length"] / across, steps * max(bird_step, min(blade_step, bird_step)), 20 * steps * blade_step)
    scene.info["end"] = round_figures(end)
    scene.set("Time/End time", scene.info["end"])
    scene.set("Time/Bird phase tolerance", 0.)
    scene.set("Output/History interval", 0.)


def draw_metal(scene, draw, young=None, density=None):
    young = round_figures(young or log_uniform(draw, 1e6, 5e11))
    density = round_figures(density or log_uniform(draw, 100., 2e4))
    material = {"Name": "custom", "Density": density, "Young's modulus": young, "Poisson's ratio": draw.choice((0., 0.3, 0.45)),
                "Hardening": "elastic"}
    if draw.random() < 0.5:
        material.update({"Hardening": "linear", "Yield stress": round_figures(young * log_uniform(draw, 1e-3, 2e-2)),
                         "Hardening modulus": round_figures(young * 0.01)})
    for path, value in material.items():
        scene.set("Blade/Material/" + path, value)
    scene.info.update(young=young, rho=density, wave=math.sqrt(young / density))


def draw_plate(scene, draw, thickness, kind="shell", facet=None):
    """A plate some bird diameters wide, its elements 0.2 to 10 particles long (the program's cost bounds their number)."""
    info = scene.info
    element = facet or info["spacing"] * log_uniform(draw, 0.2, 10.)
    length, chord = (round_figures(info["diameter"] * draw.uniform(1.5, 3.)) for _ in range(2))
    most = 20 if kind == "shell" else 12
    n_span, n_chord = (max(2, min(most, round(side / element))) for side in (length, chord))
    if kind == "shell":  # as in strikes.py
        thickness = min(thickness, 2. * min(length / n_span, chord / n_chord))
    thickness = round_figures(thickness)
    scene.set("Blade/Kind", kind)
    scene.set("Blade/Mesh/Length", length)
    scene.set("Blade/Mesh/Chord", chord)
    scene.set("Blade/Mesh/Elements along span", n_span)
    scene.set("Blade/Mesh/Elements along chord", n_chord)
    scene.set("Blade/Thickness/Value", thickness)
    shortest = min(length / n_span, chord / n_chord)
    if kind == "solid":
        layers = draw.choice((1, 1, 2))
        scene.set("Blade/Mesh/Layers", layers)
        formulation = draw.choice(BRICKS)
        shortest = min(shortest, thickness / layers)
    else:
        formulation = draw.choice(SHELLS)
    scene.set("Blade/Element/Formulation", formulation)
    info.update(length_x=length, chord=chord, n_span=n_span, n_chord=n_chord, thickness=thickness, formulation=formulation,
                element=shortest)
    return 0.5 * shortest / info["wave"]


def set_supports(scene, draw, clamped):
    scene.set("Blade/Supports/Clamped", clamped)
    scene.set("Blade/Supports/Free", ", ".join(str(b) for b in range(4) if str(b) not in clamped.split(", ")) if clamped else "0, 1, 2, 3")
    scene.info["free"] = not clamped
    scene.set("Time/Multirate", draw.choice(("true", "true", "false")))


def aim(scene, x, y, z=0.):
    scene.set("Bird/Aim point", (x, y, z))


def side(draw):
    return draw.choice((1., -1.))


def foil(scene, draw):
    """Foils of a micrometre to plates of a metre, light and heavy, soft and stiff."""
    draw_bird(scene, draw, log_uniform(draw, 1., 1500.), (0., 0., side(draw)))
    draw_metal(scene, draw)
    step = draw_plate(scene, draw, log_uniform(draw, 1e-6, 1.))
    set_supports(scene, draw, draw.choice(("0, 1, 2, 3", "0", "")))
    aim(scene, draw.uniform(0.4, 0.6) * scene.info["length_x"], draw.uniform(-0.1, 0.1) * scene.info["chord"])
    set_end(scene, step)


def soft(scene, draw):
    """Rubber, foam and skins: targets that weigh less than the layer of particles on them."""
    draw_bird(scene, draw, log_uniform(draw, 20., 400.), (0., 0., side(draw)))
    draw_metal(scene, draw, log_uniform(draw, 1e6, 1e8), log_uniform(draw, 100., 2000.))
    step = draw_plate(scene, draw, scene.info["spacing"] * log_uniform(draw, 0.1, 3.))
    set_supports(scene, draw, "0, 1, 2, 3")
    aim(scene, 0.5 * scene.info["length_x"], 0.)
    set_end(scene, step)


def rigid(scene, draw):
    """Fast birds on rigid plates, fixed or free, turned anyhow."""
    normal = [draw.gauss(0., 1.) for _ in range(3)]
    size = math.hypot(*normal)
    normal = [c / size for c in normal]
    draw_bird(scene, draw, log_uniform(draw, 1., 1500.), [-c for c in normal])
    scene.set("Blade/Kind", "rigid")
    scene.set("Blade/Rigid/Normal", normal)
    width = round_figures(scene.info["diameter"] * draw.choice((1.2, 3., 12.)))
    scene.set("Blade/Rigid/Length", width)
    scene.set("Blade/Rigid/Width", width)
    scene.set("Blade/Rigid/Half thickness", draw.choice((0., round_figures(scene.info["spacing"]))))
    if draw.random() < 0.5:
        scene.set("Blade/Rigid/Motion", "free along normal")
        scene.set("Blade/Rigid/Mass", round_figures(log_uniform(draw, 1e-3, 1.)))
        scene.info["free"] = True
    aim(scene, 0., 0.)
    scene.info.update(normal=normal, thickness=0., formulation="")
    set_end(scene, 1.)


def graze(scene, draw):
    """Angles of 5 to 90 degrees between velocity and surface, along span or chord, from both sides."""
    angle = math.radians(draw.uniform(5., 90.))
    along, up, turn = math.cos(angle), math.sin(angle) * side(draw), draw.choice(((1., 0.), (-1., 0.), (0., 1.), (0., -1.), (0.6, 0.8)))
    draw_bird(scene, draw, log_uniform(draw, 50., 600.), (along * turn[0], along * turn[1], up))
    scene.info["closing"] = scene.info["speed"] * max(0.3, abs(up))
    draw_metal(scene, draw, 1.1e11, 4430.)
    step = draw_plate(scene, draw, scene.info["spacing"] * log_uniform(draw, 0.2, 3.))
    set_supports(scene, draw, draw.choice(("0, 1, 2, 3", "0")))
    aim(scene, draw.uniform(0.2, 0.8) * scene.info["length_x"], draw.uniform(-0.3, 0.3) * scene.info["chord"])
    scene.set("Contact/Friction", draw.choice((0., 0., 0.1, 0.5)))
    set_end(scene, step)


def edge(scene, draw):
    """Aims at leading edge, tip, corner and root, across the plate or into its rim."""
    kind = draw.choice(("shell", "solid"))
    into_rim = draw.random() < 0.4
    direction = draw.choice(((0., 1., 0.), (-1., 0., 0.), (0., -1., 0.), (-0.6, 0.8, 0.))) if into_rim else (0., 0., side(draw))
    draw_bird(scene, draw, log_uniform(draw, 50., 500.), direction)
    draw_metal(scene, draw, 7e10, 2700.)
    step = draw_plate(scene, draw, scene.info["spacing"] * log_uniform(draw, 0.4, 3.), kind)
    set_supports(scene, draw, draw.choice(("0", "")) if into_rim else "0")
    x, y = scene.info["length_x"], 0.5 * scene.info["chord"]
    place = draw.choice(((0.6 * x, -y), (0.6 * x, y), (x, 0.), (x, y), (x, -y), (0., 0.), (0.05 * x, -y)))
    aim(scene, *(place if not into_rim else (0.7 * x, 0.)))
    set_end(scene, step, 500)


def brick(scene, draw):
    """Solid plates of all formulations, thin and thick."""
    draw_bird(scene, draw, log_uniform(draw, 10., 800.), (0., 0., side(draw)))
    draw_metal(scene, draw, log_uniform(draw, 1e8, 5e11))
    step = draw_plate(scene, draw, scene.info["spacing"] * log_uniform(draw, 0.2, 10.), "solid")
    set_supports(scene, draw, draw.choice(("0, 1, 2, 3", "0", "")))
    aim(scene, 0.5 * scene.info["length_x"], 0.)
    set_end(scene, step, 500)


def frame(scene, draw):
    """Bird and free plate; its twin is seen by somebody who moves."""
    draw_bird(scene, draw, log_uniform(draw, 20., 500.), (0., 0., side(draw)))
    draw_metal(scene, draw, log_uniform(draw, 1e9, 2e11), log_uniform(draw, 1000., 8000.))
    step = draw_plate(scene, draw, scene.info["spacing"] * log_uniform(draw, 0.2, 2.), draw.choice(("shell", "solid")))
    set_supports(scene, draw, "")
    aim(scene, draw.uniform(0.4, 0.9) * scene.info["length_x"], 0.)
    set_end(scene, step, 500)


def order(scene, draw):
    """A plate from a file; its twin is another order of the same points and cells."""
    draw_bird(scene, draw, log_uniform(draw, 50., 400.), (0., 0., side(draw)))
    draw_metal(scene, draw, log_uniform(draw, 1e9, 2e11), log_uniform(draw, 1000., 8000.))
    step = draw_plate(scene, draw, scene.info["spacing"] * log_uniform(draw, 0.2, 2.))
    info = scene.info
    scene.mesh = meshes.plate(info["length_x"], info["chord"], info["n_span"], info["n_chord"])
    for entry in ("Length", "Chord", "Elements along span", "Elements along chord"):
        del scene.settings["Blade/Mesh/" + entry]
    scene.set("Blade/Mesh/Generator", "file")
    for entry, value in {"Clamped": "", "Hub": "10", "Tip": "11", "Free": "12, 13"}.items():
        scene.set("Blade/Supports/" + entry, value)
    aim(scene, draw.uniform(0.4, 0.9) * info["length_x"], 0.)
    set_end(scene, step)


def fold(scene, draw):
    """A bird folds one leaf of a sheet onto the other."""
    draw_bird(scene, draw, log_uniform(draw, 30., 250.), (0., 0., -1.))
    draw_metal(scene, draw, log_uniform(draw, 1e10, 2e11), log_uniform(draw, 1000., 8000.))
    info = scene.info
    size, gap = info["diameter"], round_figures(info["diameter"] * draw.uniform(0.15, 0.6))
    thickness = round_figures(min(0.3 * gap, info["spacing"] * log_uniform(draw, 0.1, 1.)))
    n_length, n_gap = draw.randint(10, 20), draw.randint(2, 4)
    scene.mesh = meshes.folded_sheet(2.5 * size, 1.5 * size, gap, n_length, 8, n_gap)
    for entry, value in {"Kind": "shell", "Mesh/Generator": "file", "Supports/Clamped": "", "Supports/Hub": "10", "Supports/Tip": "11",
                         "Supports/Free": "12, 13", "Thickness/Value": thickness, "Element/Formulation": draw.choice(SHELLS)}.items():
        scene.set("Blade/" + entry, value)
    info.update(thickness=thickness, formulation=scene.settings["Blade/Element/Formulation"], fold=True, gap=gap, length_x=2.5 * size)
    aim(scene, 2. * size, 0., gap)
    line = [2.5 * size * k / n_length for k in range(1, n_length + 1)]  # nodes of both leaves at y = 0
    scene.set("Blade/Probes", "; ".join(f"{name}{k}: {x!r} 0 {z!r}" for name, z in (("upper", gap), ("lower", 0.)) for k, x in enumerate(line)))
    info["line"] = line
    set_end(scene, 0.5 * min(2.5 * size / n_length, gap / n_gap) / info["wave"], 1000)


def torn(scene, draw):
    """A metal that fails: holes, flying pieces and bared faces."""
    draw_bird(scene, draw, log_uniform(draw, 100., 600.), (0., 0., side(draw)))
    scene.info.update(wave=5000., young=7e10, rho=2770.)
    scene.set("Blade/Material/Name", "Al 2024 Johnson-Cook")
    scene.set("Blade/Material/Failure", draw.choice(("Johnson-Cook", "plastic strain")))
    step = draw_plate(scene, draw, scene.info["spacing"] * log_uniform(draw, 0.1, 1.), draw.choice(("shell", "shell", "solid")))
    if scene.info["formulation"] == "solid-shell":
        scene.set("Blade/Element/Formulation", "one point")
    set_supports(scene, draw, "0, 1, 2, 3")
    aim(scene, 0.5 * scene.info["length_x"], 0.)
    set_end(scene, step, 500)


def half(scene, draw):
    """Half a scene and its mirror image; its twin is the whole."""
    angle = math.radians(draw.choice((90., draw.uniform(30., 90.))))
    draw_bird(scene, draw, log_uniform(draw, 20., 500.), (draw.choice((1., -1.)) * math.cos(angle), 0., math.sin(angle) * side(draw)))
    for entry, value in {"Packing": "cubic", "Formulation": "riemann"}.items():
        scene.set("Bird/" + entry, value)
    scene.info["closing"] = scene.info["speed"] * math.sin(angle)
    draw_metal(scene, draw, log_uniform(draw, 1e9, 2e11), log_uniform(draw, 1000., 8000.))
    step = draw_plate(scene, draw, scene.info["spacing"] * log_uniform(draw, 0.2, 2.), draw.choice(("shell", "solid")))
    scene.set("Blade/Mesh/Elements along chord", 2 * ((scene.info["n_chord"] + 1) // 2))
    scene.set("Case/Symmetry plane", "y")
    set_supports(scene, draw, draw.choice(("0", "0, 1")))
    aim(scene, draw.uniform(0.4, 0.9) * scene.info["length_x"], 0.)
    set_end(scene, step, 500)


def blade(scene, draw):
    """The built-in blade, staggered, twisted, cambered and tapered, struck where shares of span and chord say."""
    draw_bird(scene, draw, log_uniform(draw, 50., 500.))
    info = scene.info
    draw_metal(scene, draw, 1.1e11, 4430.)
    step = draw_plate(scene, draw, info["spacing"] * log_uniform(draw, 0.3, 1.5), draw.choice(("shell", "solid")))
    thickness = float(scene.settings.pop("Blade/Thickness/Value"))
    for path, value in {"Mesh/Generator": "blade", "Mesh/Profile/Root radius": round_figures(info["length_x"] * draw.uniform(0., 1.)),
                        "Mesh/Profile/Chord law": f"1 + {draw.uniform(-0.3, 0.3):.3g}*s",
                        "Mesh/Profile/Stagger": f"{draw.uniform(-30., 30.):.3g} + {draw.uniform(-40., 40.):.3g}*s",
                        "Mesh/Profile/Camber": f"{draw.uniform(0., 0.12):.3g}",
                        "Thickness/Maximum": f"{thickness:.4g}*(1 - {draw.uniform(0., 0.5):.3g}*s)"}.items():
        scene.set("Blade/" + path, value)
    del scene.settings["Bird/Velocity"]
    for path, value in {"Speed": info["speed"], "Angle to surface": round_figures(draw.uniform(20., 90.)),
                        "Aim span fraction": draw.choice((0.5, 0.7, 0.95)), "Aim chord fraction": draw.choice((0.03, 0.5, 0.6, 0.97))}.items():
        scene.set("Bird/" + path, value)
    set_supports(scene, draw, "0")
    set_end(scene, step, 500)


KINDS = {"foil": foil, "soft": soft, "rigid": rigid, "graze": graze, "edge": edge, "brick": brick, "frame": frame, "order": order,
         "fold": fold, "torn": torn, "half": half, "blade": blade}
