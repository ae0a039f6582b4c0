"""ParaView opens what runs write, by prm/view.py: pvpython view_test.py PROGRAM SOURCE_FOLDER PICTURES

Coarse strikes, three instants each; PICTURES/<case>_<k>.png are there to be looked at.
"""

import pathlib
import shutil
import subprocess
import sys
import tempfile

PROGRAM, TOP, PICTURES = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
sys.path.insert(0, str(TOP / "prm"))

import view  # noqa: E402
from vtkmodules.util.numpy_support import vtk_to_numpy  # noqa: E402
from vtkmodules.vtkIOImage import vtkPNGReader  # noqa: E402

CASES = {  # case: spacing of its particles (m), end (s), instants (s)
    "frontal": (0.005, 4e-3, (0.2e-3, 0.5e-3, 4e-3)),
    "oblique": (0.004, 1.5e-3, (0.1e-3, 0.6e-3, 1.5e-3)),
    "fan-blade": (0.015, 3e-3, (0., 1e-3, 3e-3)),
}


def read(path):
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())[:, :3].astype(int)


def check(pictures):
    """Each shows something, not everything, in colours of its own."""
    for path, pixels in pictures.items():
        drawn = (pixels.min(axis=1) < 200).mean()
        assert 0.02 < drawn < 0.7, f"{path}: {drawn:.1%} of it are drawn"
        spread = pixels.max(axis=1) - pixels.min(axis=1)
        assert (spread > 60).mean() > 0.01, f"{path}: no colours of stress or speed"
    paths = list(pictures)
    for one, other in zip(paths, paths[1:]):
        changed = (abs(pictures[one] - pictures[other]).max(axis=1) > 30).mean()
        assert changed > 0.02, f"{one} and {other} are the same but for {changed:.1%}"


def main():
    PICTURES.mkdir(parents=True, exist_ok=True)
    for case, (spacing, end, instants) in CASES.items():
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([str(PROGRAM), "run", str(TOP / "prm" / f"{case}.prm"), "--output", folder, "--set",
                            f"Bird/Particle spacing={spacing}", "--set", f"Time/End time={end}", "--set",
                            "Output/Field interval=1e-4"], check=True, stdout=subprocess.DEVNULL)
            view.show(view.parse([folder, "--at", *map(str, instants)]))
            paths = []
            for k in range(len(instants)):
                paths.append(PICTURES / f"{case}_{k}.png")
                shutil.move(f"{folder}/view_{k}.png", paths[-1])
            assert pathlib.Path(folder, "view.pvsm").stat().st_size > 0
            check({path: read(path) for path in paths})
            print(f"{case}: drawn at {', '.join(f'{1e3 * time:g}' for time in instants)} ms")


if __name__ == "__main__":
    main()
