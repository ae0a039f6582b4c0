#!/usr/bin/env python3
"""Whether a build for this machine reads an archive that one for AVX2 has written, and goes on equally.

    python3 tests/archive_width/archive_width.py --build DIR --program NATIVE

Exit status: 0 they go on equally, 1 they do not, 77 not comparable here (no AVX2). The build folder is that of the
instruction counts (tests/benchmarks/instruction_counts.py), which has the loops for AVX2 already.
"""

import argparse
import os
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "benchmarks"))
import instruction_counts  # noqa: E402


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", required=True)
    parser.add_argument("--program", required=True)
    options = parser.parse_args()
    if not instruction_counts.has_avx2():
        print("This processor has no AVX2: another register width cannot be run.")
        return instruction_counts.NOT_COMPARABLE
    writer = instruction_counts.build_program(options.build, "archive_width")
    with tempfile.TemporaryDirectory() as folder:
        state = os.path.join(folder, "state")
        subprocess.run([writer, "write", state], check=True)
        return subprocess.run([options.program, "read", state], check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
