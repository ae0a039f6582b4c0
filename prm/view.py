"""Blade and bird of a run in ParaView, in step: the blade displaced and coloured by stress, particles as spheres.

    pvpython prm/view.py runs/frontal                        -> runs/frontal/view.pvsm, to be opened in ParaView
    pvpython prm/view.py runs/frontal --at 0.5e-3 3e-3 11e-3 -> runs/frontal/view_0.png, ... as well

    --field NAME     of the blade, default von Mises stress (of shells: on the top face)
    --range A B      of the colours, default 0 to the largest value in time
    --from X Y Z     where the camera looks from, by default tip, leading edge (-y) and struck side are seen
    --size W H       of the pictures, default 1280 800

Needs ParaView 5.9 or newer and numpy (Debian: paraview, python3-paraview, python3-numpy).
"""

import argparse
import json
import math
import pathlib
import re
import sys


def parse(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("run", type=pathlib.Path)
    parser.add_argument("--at", type=float, nargs="*", default=[], metavar="SECONDS")
    parser.add_argument("--field")
    parser.add_argument("--range", type=float, nargs=2, metavar=("A", "B"))
    parser.add_argument("--from", type=float, nargs=3, dest="direction", metavar=("X", "Y", "Z"))
    parser.add_argument("--size", type=int, nargs=2, default=(1280, 800), metavar=("W", "H"))
    options = parser.parse_args(arguments)
    for part in ("blade", "bird"):
        if not (options.run / f"{part}.pvd").is_file():
            sys.exit(f"{options.run} has no {part}.pvd: the scene has no {part}, or Output/{part.capitalize()} fields is false.")
    return options


def particle_radius(run, density):
    """Half the edge of the cube that a particle fills at this density (kg/m^3), m; of a run without an end half the spacing."""
    summary = run / "summary.json"
    if summary.is_file():
        bird = json.loads(summary.read_text(encoding="utf-8"))["bird"]
        return 0.5 * (bird["mass"] / bird["particles"] / density) ** (1. / 3.)
    entries = (run / "parameters.prm").read_text(encoding="utf-8")
    number, millimetres = re.search(r"set Particle spacing\s*=\s*([0-9.eE+-]+)\s*(mm)?", entries).groups()
    return 0.5 * float(number) * (1e-3 if millimetres else 1.)


def colour(view, display, association, name, scale_range, title, simple):
    simple.ColorBy(display, (association, name))
    table = simple.GetColorTransferFunction(name)
    table.RescaleTransferFunction(*scale_range)
    bar = simple.GetScalarBar(table, view)
    bar.Title, bar.ComponentTitle = title, ""
    bar.TitleColor = bar.LabelColor = (0., 0., 0.)
    display.SetScalarBarVisibility(view, True)
    return bar


def join(one, other):
    """The box around two boxes (xmin, xmax, ymin, ...)."""
    return other if one is None else [max(pair) if k % 2 else min(pair) for k, pair in enumerate(zip(one, other))]


def unit_of(run, field):
    """Units stand in the files as attributes, which ParaView does not read."""
    text = (run / "fields" / "blade_0000.vtu").read_text(encoding="utf-8")
    found = re.search(f'Name="{re.escape(field)}"[^>]* units="([^"]*)"', text)
    return found.group(1) if found else "-"


def fast_speed(bird, time):
    """What 99 % of the particles stay below, m/s: a jet is faster than all else."""
    import numpy
    from paraview import servermanager
    from vtkmodules.util.numpy_support import vtk_to_numpy

    bird.UpdatePipeline(time)
    if "velocity" not in bird.PointData.keys():
        return 0.
    velocities = vtk_to_numpy(servermanager.Fetch(bird).GetPointData().GetArray("velocity"))
    return float(numpy.quantile(numpy.linalg.norm(velocities, axis=1), 0.99))


def look_at(view, bounds, direction):
    """All that moves is in sight at every time."""
    focus = [0.5 * (bounds[2 * d] + bounds[2 * d + 1]) for d in range(3)]
    camera = view.GetActiveCamera()
    camera.SetFocalPoint(*focus)
    camera.SetPosition(*(f + d for f, d in zip(focus, direction)))
    camera.SetViewUp(0., 0., 1.)
    view.GetRenderer().ResetCamera(bounds)
    camera.Zoom(1.3)  # a box's corners are mostly empty


def show(options):
    from paraview import simple

    simple._DisableFirstRenderCameraReset()
    view = simple.CreateView("RenderView")
    view.ViewSize = list(options.size)
    view.UseColorPaletteForBackground = 0
    view.Background = (1., 1., 1.)

    blade = simple.PVDReader(FileName=str((options.run / "blade.pvd").resolve()), registrationName="blade")
    times = list(blade.TimestepValues)
    fields = blade.CellData.keys()
    field = options.field or next(name for name in ("von_mises_stress_top", "von_mises_stress", *fields) if name in fields)
    if field not in fields:
        sys.exit(f"The blade has no cell field '{field}'. There are: {', '.join(fields)}.")
    is_deformed = "deformed" in blade.FieldData.keys()
    bent = blade if is_deformed else simple.WarpByVector(Input=blade, Vectors=("POINTS", "displacement"),
                                                         registrationName="blade displaced")
    largest, bounds = 0., None
    for time in times:
        bent.UpdatePipeline(time)
        largest = max(largest, bent.CellData[field].GetRange()[1])
        bounds = join(bounds, bent.GetDataInformation().GetBounds())
    shown = simple.Show(bent, view)
    shown.Representation = "Surface With Edges"
    shown.Ambient, shown.Diffuse = 0.7, 0.4  # the far face is as bright
    shown.EdgeColor, shown.LineWidth = (0.5, 0.5, 0.5), 0.5
    bar = colour(view, shown, "CELLS", field, options.range or (0., largest or 1.), f"{field.replace('_', ' ')}, {unit_of(options.run, field)}", simple)
    bar.WindowLocation = "Lower Right Corner"

    bird = simple.PVDReader(FileName=str((options.run / "bird.pvd").resolve()), registrationName="bird")
    particles = simple.Show(bird, view)
    particles.SetRepresentationType("Point Gaussian")
    particles.ShaderPreset = "Sphere"
    bird.UpdatePipeline(0.)
    particles.GaussianRadius = particle_radius(options.run, bird.PointData["density"].GetRange()[0])
    bounds = join(bounds, bird.GetDataInformation().GetBounds())
    flight = [sum(bird.PointData["velocity"].GetRange(d)) for d in range(3)]  # twice the velocity
    fastest = max(fast_speed(bird, time) for time in bird.TimestepValues)  # particles speed up, and further birds come
    bar = colour(view, particles, "POINTS", "velocity", (0., fastest), "speed of the bird, m/s", simple)
    bar.WindowLocation = "Upper Right Corner"
    simple.GetColorTransferFunction("velocity").ApplyPreset("Viridis (matplotlib)", True)
    simple.GetColorTransferFunction("velocity").RescaleTransferFunction(0., fastest)

    clock = simple.AnnotateTimeFilter(Input=blade, Format="{time:.2f} ms", Scale=1000., registrationName="time")
    label = simple.Show(clock, view)
    label.Color, label.WindowLocation = (0., 0., 0.), "Upper Left Corner"

    simple.GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
    behind = [-component / math.hypot(*flight) for component in flight]  # where the bird comes from
    look_at(view, bounds, options.direction or (0.4 + 0.5 * behind[0], -1. + 0.5 * behind[1], 0.5 * behind[2]))
    simple.SaveState(str(options.run / "view.pvsm"))
    for number, time in enumerate(options.at):
        view.ViewTime = min(times, key=lambda of_file: abs(of_file - time))
        simple.Render(view)
        simple.SaveScreenshot(str(options.run / f"view_{number}.png"), view, ImageResolution=list(options.size))


if __name__ == "__main__":
    show(parse(sys.argv[1:]))
