"""What is said of a finished run from outside: sums of its own over the columns of history.csv, and what a strike cannot do."""

import math

import strike

# Shares of the energy at the start, of the largest momentum, of a particle's spacing.
NEGATIVE, ENERGY, MOMENTUM, DEEP = 1e-4, 1e-2, 1e-9, 0.5
SHARES = 1e-9  # of sums of parts: round-off
# Pairs of the standard formulation, and of riemann's without its correction of gradients, push along the line between them: round-off,
# of float pairs 6e-8 of the sum of m |x| |v|, of which the program's scale is a hundredth where the bird aims at the origin. Corrected
# gradients do not, so that a coarse bird turns a little by itself; on facets much smaller than the offset of a touch a part of its couple
# is lost (couple.h; at most 1e-7 of 1225 drawn scenes).
ANGULAR, ANGULAR_OF_FLOAT, ANGULAR_OF_COUPLES, ANGULAR_OF_METHOD = 1e-9, 6e-6, 1e-4, 1e-2


def angular_limit(scene, result):
    info, settings = scene.info, scene.settings
    riemann = [section for section in info.get("birds", ["Bird"]) if settings[section + "/Formulation"] == "riemann"]
    is_corrected = any(settings.get(section + "/Gradient correction", "true") == "true" for section in riemann)
    has_couples = info.get("element", math.inf) < info["spacing"] + info["thickness"]
    if is_corrected or has_couples:
        return ANGULAR_OF_METHOD if is_corrected else ANGULAR_OF_COUPLES
    has_float = any(settings.get(section + "/Pair precision", "float") == "float" for section in riemann)
    return ANGULAR_OF_FLOAT if has_float else ANGULAR


# Leapfrog at steps dt keeps a steady rotation's kinetic energy to (w dt)^2/8 of it, 1e-5 at most where w dt is below 1e-2.
OF_ROTATION = 1e-5


def energy_scale(scene, result):
    """J, what errors are shares of: the energy at the start; on a hub that of the bird as the hub sees it come, for the blade's rotation is
    the hub's; under loads with the most that these gave or took."""
    if scene.info.get("turns"):
        return scene.info["closing_energy"] + OF_ROTATION / ENERGY * result.most("blade_kinetic")
    return result.initial_energy() + (max(map(abs, result.columns["blade_external_work"])) if scene.info.get("pushed") else 0.)


def energy_residual(result, scale):
    """Largest sum of all energies less what there was and came from outside, over `scale`."""
    columns = result.columns
    internal = ("bird_elastic", "bird_dissipated") if "bird_elastic" in columns else ("bird_internal",)
    names = [n for n in (*strike.NOT_NEGATIVE, *internal) if n in columns and not n.startswith(("bird_elastic", "bird_dissipated"))]
    names += [n for n in (*internal, "staggering") if n in columns]
    total = [sum(columns[n][k] for n in names) - columns.get("blade_external_work", [0.] * (k + 1))[k]
             for k in range(len(columns["time"]))]
    return max(abs(value - total[0]) for value in total) / scale


def loads_impulse(scene, axis, time):
    """N s that dead loads have given by `time` (s), which are linear in it, as kicks are exact for; nothing where other loads are."""
    settings, total = scene.settings, 0.
    if any("Blade/" + entry in settings for entry in ("Loads/Pressure", "Loads/Damping")):
        return None
    for _, force, _, law in scene.info.get("point_loads", ()):
        at_start, rate = (eval(law, {"t": t}) for t in (0., 1.))  # an expression drawn here, of t alone
        total += force["xyz".index(axis)] * (at_start * time + 0.5 * (rate - at_start) * time**2)
    return total


def momentum_residual(scene, result):
    """Of the bird against contact's impulse, and of the blade and its supports against the same and what loads gave."""
    columns, largest, scale = result.columns, 0., 1e-300
    for axis in "xyz":
        bird, blade, held, given = (columns[f"{name}_{axis}"] for name in ("bird_momentum", "blade_momentum", "support_impulse",
                                                                          "contact_impulse"))
        scale = max(scale, max(map(abs, bird)), max(map(abs, blade)), max(map(abs, given)))
        for k, time in enumerate(columns["time"]):
            largest = max(largest, abs(bird[k] - bird[0] + given[k]))
            pushed = loads_impulse(scene, axis, time)
            if pushed is not None:
                largest = max(largest, abs(blade[k] - blade[0] + held[k] - given[k] - pushed))
    return largest / scale


def do_cross(a, b, c, d):
    """Whether the segments a-b and c-d of a plane do."""
    def side(p, q, r):
        return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
    return side(a, b, c) * side(a, b, d) < 0. and side(c, d, a) * side(c, d, b) < 0.


def share_of_crossed_rows(scene, columns):
    """Of a hundred rows, in how many the middle lines of the leaves (y = 0) cut one another."""
    line, gap, rows = scene.info["line"], scene.info["gap"], len(columns["time"])
    chosen = range(0, rows, max(1, rows // 100))

    def leaf(name, height, row):
        return [(x + columns[f"probe_{name}{k}_ux"][row], height + columns[f"probe_{name}{k}_uz"][row]) for k, x in enumerate(line)]
    n_crossed = 0
    for row in chosen:
        upper, lower = leaf("upper", gap, row), leaf("lower", 0., row)
        n_crossed += any(do_cross(*upper[i:i + 2], *lower[j:j + 2]) for i in range(len(line) - 1) for j in range(len(line) - 1))
    return n_crossed / len(chosen)


def judge(scene, result):
    """Figures of the row, and faults."""
    columns, scale, faults = result.columns, energy_scale(scene, result), []
    if any(not math.isfinite(v) for values in columns.values() for v in values):
        return {}, ["a number of history.csv is not finite"]
    fall = result.largest_fall("contact_dissipated") / scale
    figures = {"taken": columns["contact_dissipated"][-1] / scale, "error": result["energy/max_relative_error"],
               "sum": energy_residual(result, scale), "momentum": momentum_residual(scene, result),
               "angular": result["angular_momentum/max_relative_error"],
               "depth": result["contact/max_penetration_over_spacing"]}
    if fall > 1e-9:
        faults.append(f"contact_dissipated falls by {fall:.2g} E0")
    for name in strike.NOT_NEGATIVE:
        if result.least(name) < -NEGATIVE * scale:
            faults.append(f"{name} {result.least(name) / scale:.2g} E0")
    for name, limit in (("error", ENERGY), ("sum", ENERGY), ("momentum", MOMENTUM), ("depth", DEEP),
                        ("angular", angular_limit(scene, result))):
        if not figures[name] < limit:
            faults.append(f"{name} {figures[name]:.2g} above {limit:g}")
    origins = dict(result["energy/error_origins"])
    origins["contact"] += origins.pop("steps")  # with subcycles the works of contact's two sides are booked in steps of their own
    for name, made in origins.items():
        if abs(made) > ENERGY * scale:
            faults.append(f"made by {name}: {made / scale:.2g} E0")
    is_driven = scene.info.get("turns") or scene.info.get("pushed")
    if not is_driven and result.most("blade_kinetic") + result.least("bird_kinetic") > 1.01 * scale:
        faults.append(f"blade_kinetic {result.most('blade_kinetic') / scale:.3g} E0")
    if scene.info.get("fold"):
        figures["crossed"] = share_of_crossed_rows(scene, columns)
        if figures["crossed"] > 0.05:
            faults.append(f"leaves go through one another in {figures['crossed']:.2g} of the rows")
    if "most_speed" in scene.info:
        faults += judge_shares(scene, result)
        given = math.hypot(*result["contact/impulse"])
        figures["impulse"] = given / (result["bird/mass"] * scene.info["most_speed"])
        if figures["impulse"] > 2.05:
            faults.append(f"impulse {figures['impulse']:.3g} of mass times the fastest approach")
    else:
        judge_impulse(scene, result, figures, faults)
    return figures, faults


def judge_shares(scene, result):
    """Of several birds the impulses, of a row those and the energies of its blades, are together what history.csv has."""
    columns, faults = result.columns, []

    def compare(name, parts, whole, scale):
        if abs(sum(parts) - whole) > SHARES * scale:
            faults.append(f"{name}: {sum(parts):.9g} by parts, {whole:.9g}")
    if scene.info.get("n_birds", 1) > 1:
        for axis in "xyz":
            of_birds = [columns[f"bird_{k + 1}_impulse_{axis}"][-1] for k in range(scene.info["n_birds"])]
            compare(f"impulse {axis}", of_birds, columns[f"contact_impulse_{axis}"][-1], sum(map(abs, of_birds)) + 1e-12)
    if "Blade/Mesh/Row/Blades" in scene.settings:
        n = int(scene.settings["Blade/Mesh/Row/Blades"])
        patches, blades = result.table("patches"), result.table("blades")
        for axis in "xyz":
            of_blades = [patches[f"blade_{k + 1}.impulse_{axis}"][-1] for k in range(n)]
            compare(f"impulse {axis}", of_blades, columns[f"contact_impulse_{axis}"][-1], sum(map(abs, of_blades)) + 1e-12)
        for name, column in (("kinetic_energy", "blade_kinetic"), ("elastic_energy", "blade_elastic"), ("plastic_work", "blade_plastic")):
            of_blades = [values[-1] for key, values in blades.items() if key.endswith("." + name)]
            if of_blades and column in columns:
                compare(column, of_blades, columns[column][-1], sum(map(abs, of_blades)) + 1e-12)
    return faults


def judge_impulse(scene, result, figures, faults):
    """A plate in whose way the bird is gets m v, more by restitution: 5 % and what some hundred particles make of it from a rigid
    plate that stands; from an elastic or a free one up to as much again."""
    info = scene.info
    velocity = result["aim/velocity"]
    flight = [v / info["speed"] for v in velocity]
    along = info.get("normal", flight if scene.kind in ("strike", "edge", "blade") else (0., 0., 1.))
    brought = abs(sum(v * n for v, n in zip(velocity, along))) * info["mass"]
    given = abs(sum(v * n for v, n in zip(result["contact/impulse"], along)))
    figures["impulse"] = given / brought
    if figures["impulse"] > (1.15 if scene.kind == "rigid" and not info.get("free") else 2.05):
        faults.append(f"impulse {figures['impulse']:.3g} m v")
    wide = scene.kind == "rigid" and not info.get("free") and float(scene.settings["Blade/Rigid/Length"]) > 10. * info["diameter"]
    if wide and info["end"] * info["speed"] > 1.19 * info["length"] and figures["impulse"] < 0.85:
        faults.append(f"impulse only {figures['impulse']:.3g} m v: particles pass the plate")
