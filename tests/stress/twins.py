"""A scene's twin: the same physics written down otherwise, and how its answer compares."""

import math
import re

import crossings
import likes
import numpy as np
import placing

# Relative differences that are let pass, of impulse and energies, and of the peak force: round-off, which grows while the flow bounces (pairs
# are in single precision), in single peaks the more. Scaling by a power of two changes no mantissa, but a cube root differs in its last digit
# sometimes, which 1600 steps made 7e-5.
# A frontal bird can have particles exactly above edges or in a plate's middle plane, which in a hollow, or aimed at a corner, go to either
# side: where its twin differs by more, so must the scene itself from one nudged by so little (TIE).
ROUND_OFF, SINGLE_PEAK = 2e-3, 2e-2
TIE = 2.
LENGTHS = ("Bird/Particle spacing", "Bird/Aim point", "Blade/Mesh/Length", "Blade/Mesh/Chord", "Blade/Thickness/Value",
           "Blade/Mesh/Profile/Root radius", "Blade/Rigid/Length", "Blade/Rigid/Width", "Blade/Rigid/Half thickness", "Time/End time", "Blade/Probes")
MASSES = ("Bird/Mass", "Blade/Rigid/Mass")
SECTIONS = ("end", "tip", "root", "contact", "plastic", "energy", "steps")


def scaled(scene, factor):
    twin = scene.copy()
    for path, text in twin.settings.items():
        power = 1 if path in LENGTHS else 3 if path in MASSES else 0
        if path == "Blade/Probes":
            groups = [part.split(":") for part in text.split(";")]
            text = "; ".join(name.strip() + ": " + " ".join(repr(float(x) * factor) for x in where.split()) for name, where in groups)
        elif power:
            text = ", ".join(repr(float(x) * factor**power) for x in text.split(","))
        twin.settings[path] = text
    if "Blade/Thickness/Maximum" in twin.settings:
        twin.set("Blade/Thickness/Maximum", f"{factor!r}*({twin.settings['Blade/Thickness/Maximum']})")
    if twin.mesh:
        twin.mesh = twin.mesh.moved(lambda p: tuple(factor * x for x in p))
    return twin, factor**3


def mirrored(scene):
    """The bird from the other side of a plate in z = 0."""
    twin = scene.copy()
    for path in ("Bird/Velocity", "Bird/Aim point"):
        x, y, z = (float(c) for c in twin.settings[path].split(","))
        twin.set(path, (x, y, -z))
    if twin.settings.get("Bird/Packing") == "fcc":
        twin.set("Bird/Roll", 90.)  # what mirrors that lattice, whichever way it is cut
    return twin, 1.


def moving(scene, draw):
    """Seen by somebody who flies along with a part of the bird's speed."""
    twin = scene.copy()
    share = draw.choice((-1., 0.5, 0.95))
    velocity = [float(c) for c in twin.settings["Bird/Velocity"].split(",")]
    twin.set("Bird/Velocity", [(1. - share) * c for c in velocity])
    twin.set("Blade/Loads/Initial velocity", "; ".join(repr(-share * c) for c in velocity))
    return twin, 1.


def reordered(scene, draw):
    twin = scene.copy()
    twin.mesh = twin.mesh.listed(draw.random() < 0.5, draw.randrange(1000))
    return twin, 1.


def whole(scene):
    twin = scene.copy()
    del twin.settings["Case/Symmetry plane"]
    return twin, 1.


def choose(scene, draw):
    """(name, (twin, factor of impulses and energies))."""
    if scene.kind == "order":
        return "order", reordered(scene, draw)
    if scene.kind == "frame":
        return "frame", moving(scene, draw)
    if scene.kind == "half":
        return "whole", whole(scene)
    if scene.kind in ("graze", "edge", "torn") or (scene.kind in ("foil", "soft", "brick") and draw.random() < 0.3):
        z = float(scene.settings["Bird/Velocity"].split(",")[2])
        return ("mirror", mirrored(scene)) if z != 0. else ("scale", scaled(scene, 2.**10))
    return "scale", scaled(scene, draw.choice((2.**-10, 2.**10)))


def difference(name, one, two, factor, tolerance=ROUND_OFF, of_peak=SINGLE_PEAK):
    """What differs between two finished runs: a list of words, and the largest relative difference of the impulse."""
    faults = []
    norm = [math.hypot(*result["contact/impulse"]) for result in (one, two)]
    if max(norm[0], norm[1] / factor) < 1e-12 * math.hypot(*one["bird/momentum"]):
        return faults, 0.  # a miss: what the first touch, found to round-off, leaves
    largest = abs(norm[1] - factor * norm[0]) / max(factor * norm[0], 1e-300)
    if largest > tolerance:
        faults.append(f"twin {name}: impulse {norm[0]:.6g} and {norm[1] / factor:.6g} N s")
    peaks = [result["contact/peak_force"] for result in (one, two)]
    peaks[1] /= factor**(2. / 3.) if name == "scale" else 1.
    if abs(peaks[0] - peaks[1]) > of_peak * max(peaks):
        faults.append(f"twin {name}: peak force {peaks[0]:.6g} and {peaks[1]:.6g} N")
    if name != "frame":
        for part in ("bird_kinetic", "blade_kinetic", "blade_plastic"):
            a, b = one.columns[part][-1], two.columns[part][-1] / factor
            if abs(a - b) > 2. * tolerance * one.initial_energy():
                faults.append(f"twin {name}: {part} {a:.6g} and {b:.6g} J")
    return faults, largest


def summary_difference(one, two):
    """Sections of two summaries of one run that are not the same to the last digit."""
    return [section for section in SECTIONS if repr(one.summary.get(section)) != repr(two.summary.get(section))]


# Of a scene elsewhere: what its answer may differ by, as so many times what a change of aim and speed by the relative precision of a
# float pair changes it, besides round-off of a few hundred steps (positions at 1000 m: 1e-13 m, 1e-10 spacings). Float pairs move a
# particle by some 1e-8 m in a hundred steps, and one that touches in the last of a step or the first of the next makes 1e-4 of the impulse:
# where a scene with such pairs differs by more, but by less than ROUND_OFF, it must not with pairs in double precision.
FLOAT, GROWTH, PLACED = 1.2e-7, 30., 1e-5


def nudged(scene, draw):
    """The scene with aim and speed changed by a float's precision of a spacing and of themselves, to one side and to the other."""
    twins = scene.copy(), scene.copy()
    entries = [(section, *of) for section in placing.sections_of_birds(scene)
               for of in (("Aim point", scene.info["spacing"]), ("Velocity", scene.info["speed"]))]
    for section, entry, scale in entries:
        path, changes = f"{section}/{entry}", [scale * FLOAT * draw.uniform(-1., 1.) for _ in range(3)]
        for twin, sign in zip(twins, (1., -1.)):
            twin.set(path, [float(x) + sign * change for x, change in zip(scene.settings[path].split(","), changes)])
    return twins


def compare_twin(name, twin, factor, scene, first, draw, run):
    """Faults and the difference."""
    more = ("Output/Bird fields=true", "Output/Field interval=0") if name == "whole" else ()
    second = run(twin, "twin", *more)
    if name == "whole" and crossings.has_row_in_plane(second.folder, scene.info["spacing"]):
        return [], 0.  # particles in the plane of symmetry, as a half has none: another bird
    if second.code != 0:
        return [f"twin {name}: exit {second.code}: {second.stop()}"], math.inf
    faults, largest = difference(name, first, second, factor)
    if not faults:
        return faults, largest
    change = peak = 0.
    for number in range(2):
        for side, moved in enumerate(nudged(twin, draw)):
            result = run(moved, f"nudged{number}{side}")
            if result.code == 0:
                change = max(change, difference(name, second, result, 1.)[1])
                peak = max(peak, abs(result["contact/peak_force"] / second["contact/peak_force"] - 1.))
    return difference(name, first, second, factor, ROUND_OFF + TIE * change, SINGLE_PEAK + TIE * peak)


def placed_figures(result, closing_energy):
    """What does not depend on who looks, over the momentum or the energy with which the bird comes; a peak over itself."""
    columns = result.columns
    momentum = result["bird/mass"] * math.sqrt(2. * closing_energy / result["bird/mass"])
    figures = {"impulse": np.array(result["contact/impulse"]) / momentum, "peak": np.array([result["contact/peak_force"]])}
    for name in ("blade_plastic", "blade_elastic", "contact_dissipated", "bird_dissipated"):
        figures[name] = np.array([columns.get(name, [0.])[-1] / closing_energy])
    return figures


def placed_difference(one, two, turn=np.eye(3)):
    """Largest difference, the peak's as a share of it and a tenth of it counted: a single evaluation of contact."""
    peak = max(one["peak"][0], two["peak"][0], 1e-300)
    return max(0.1 * abs(one["peak"][0] - two["peak"][0]) / peak if name == "peak" else
               float(np.abs((turn @ one[name] if name == "impulse" else one[name]) - two[name]).max()) for name in one)


class Elsewhere:
    """Runs of a scene's likes against its own, and what round-off may make of them, found when it is first asked for."""

    def __init__(self, scene, first, draw, run, prefix=""):
        info = scene.info
        self.scene, self.draw, self.run, self.prefix = scene, draw, run, prefix
        self.grown, self.stops, self.exact = None, [], None
        self.energy = info.get("closing_energy", 0.5 * info["mass"] * info["speed"]**2)
        self.reference = placed_figures(first, self.energy)

    def differ(self, twin, name, turn=np.eye(3)):
        """Largest difference, or words."""
        result = self.run(twin, self.prefix + name)
        if result.code == 3 and self.tolerance() and reason(result) in self.stops:
            return 0.  # at the border: nudged, it stops for the same reason
        if result.code != 0:
            return f"exit {result.code}: {result.stop()}"
        return placed_difference(self.reference, placed_figures(result, self.energy), turn)

    def tolerance(self):
        if self.grown is None:
            nudges = [self.run(moved, f"{self.prefix}nudged{k}{side}") for k in range(2) for side, moved in enumerate(nudged(self.scene, self.draw))]
            self.grown = max((placed_difference(self.reference, placed_figures(n, self.energy)) if n.code == 0 else 0.) for n in nudges)
            self.stops = [reason(n) for n in nudges if n.code == 3]
        return PLACED + GROWTH * self.grown

    def exactly(self):
        """The same of the scene with pairs in double precision, or None where it has them or does not run so."""
        if self.exact is None and has_float_pairs(self.scene):
            scene = with_double_pairs(self.scene)
            first = self.run(scene, "exact")
            if first.code == 0:
                self.exact = Elsewhere(scene, first, self.draw, self.run, "exact-")
        return self.exact

    def compare(self, twin, name, turn=np.eye(3)):
        """Nothing or one line, and the largest difference."""
        largest = self.differ(twin, name.replace(" ", "-"), turn)
        if not isinstance(largest, str):
            if largest <= PLACED or largest <= self.tolerance():
                return [], largest
            if largest <= ROUND_OFF and self.exactly():
                faults, _ = self.exactly().compare(with_double_pairs(twin), name, turn)
                return ["with double pairs, " + f for f in faults], largest
        return [f"{name}: {largest if isinstance(largest, str) else f'{largest:.2g}'}, tolerance {self.tolerance():.2g}"], largest


def reason(result):
    """What a run that stops says first, up to its numbers."""
    return re.split(r"[:\d]", result.stop())[0]


def has_float_pairs(scene):
    return any(scene.settings.get(section + "/Pair precision", "float") == "float" for section in placing.sections_of_birds(scene))


def with_double_pairs(scene):
    twin = scene.copy()
    for section in placing.sections_of_birds(scene):
        twin.set(section + "/Pair precision", "double")
    return twin


def compare_places(elsewhere):
    """Faults, the place's name and the difference. Where all at once (turned, mirrored, shifted, moving) differs, each alone says more."""
    scene = elsewhere.scene
    place = placing.draw_place(scene, elsewhere.draw)
    faults, largest = elsewhere.compare(place.apply(scene), place.name, place.turn)
    if faults:
        for alone in placing.apart(scene, elsewhere.draw, place):
            faults.append(f"{alone.name} alone: {elsewhere.differ(alone.apply(scene), alone.name, alone.turn)}")
    return faults, place.name, largest if not isinstance(largest, str) else math.inf


def compare_likes(elsewhere):
    """Faults, the name of the way of telling that differs most, and by how much."""
    faults, worst, largest = [], "", 0.
    for name, twin, turn in likes.told_otherwise(elsewhere.scene):
        more, difference_of = elsewhere.compare(twin, name, turn)
        faults += more
        size = math.inf if isinstance(difference_of, str) else difference_of
        if size >= largest:
            worst, largest = name, size
    return faults, worst, largest
