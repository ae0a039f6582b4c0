"""Bird strikes on blades in Python: makes runs with the program birdstrike and reads their folders.

    from birdstrike import Case, Run, study

    run = Case("prm/frontal.prm").set("Bird/Particle spacing", "4 mm").run("runs/coarse")
    run.summary["tip"]["peak"]                          # m
    run.tip.time, run.tip.values                        # s, m
    Run("runs/frontal").blade(3e-3).cells["thickness"]  # of a run that is there: the field file nearest to 3 ms

    made = study(Case("prm/frontal.prm"), {"Bird/Particle spacing": ["4 mm", "3 mm"]})
    made["Tip: peak (mid-chord)"]                       # m, a value a run

The program is looked for as find_program says. What it refuses or loses raises Failed. Units are those of the files: SI.
"""

import importlib

for _needed in ("numpy", "h5py"):
    try:
        importlib.import_module(_needed)
    except ModuleNotFoundError as error:
        if error.name != _needed:
            raise
        raise ModuleNotFoundError(f"The package birdstrike needs {_needed}, which is not installed for this Python.\n"
                                  f"  Action: apt-get install python3-{_needed} on Debian, else pip install {_needed}.",
                                  name=_needed) from None

from .case import Case
from .mesh import Mesh
from .program import Failed, find_program
from .run import Curve, Profile, Run
from .studies import Study, study

__all__ = ["Case", "Curve", "Failed", "Mesh", "Profile", "Run", "Study", "find_program", "study"]
__version__ = "0.3.0"
