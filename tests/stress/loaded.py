"""Runs of a program that is loaded once for all of them (loaded_once.cc), where its library stands beside it; else one by one."""

import functools
import os
import subprocess
import tempfile

import strike


class Loaded:
    def __init__(self, program, library):
        self.words = tempfile.NamedTemporaryFile(mode="r", errors="replace")
        self.process = subprocess.Popen([program], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
                                        env={**os.environ, "LD_PRELOAD": library})

    def start(self, command, folder, limit):
        """What strike.start() returns."""
        self.process.stdin.write("\t".join([folder, self.words.name, str(int(limit) + 1), *command[1:]]) + "\n")
        self.process.stdin.flush()
        code = int(self.process.stdout.readline())
        if code == -14:  # SIGALRM
            return -9, f"no end within {limit:g} s"
        self.words.seek(0)
        return code, self.words.read()


@functools.lru_cache
def starter(program):
    """One a process."""
    library = os.path.join(os.path.dirname(program), "libloaded_once.so")
    return Loaded(program, library).start if os.path.exists(library) else strike.start
