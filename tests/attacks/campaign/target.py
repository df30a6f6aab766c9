# SPDX-License-Identifier: BSD-3-Clause
"""What is attacked: small runs of every protocol, and what an undisturbed one leaves."""

import json
import os
import pathlib
import shutil
import subprocess
import sys

TESTS = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(TESTS / "cli"), str(TESTS / "attacks")]

from bagnold import PROGRAM, changed, environment, scene_text  # noqa: E402

# A checkpoint wherever there can be one, and no clock in it.
OFTEN = {"output__checkpoint_minutes": 1e-9, "disks__count": 16}
SHORT = {**OFTEN, "shear__strain": 2.0**-6, "output__sample_strain": 2.0**-8}
TRAJECTORY = {"output__trajectory_strain": 2.0**-9}
EVERYTHING = {"measure__contacts": True, "measure__correlations": True, "measure__profiles": True,
              "measure__rotation": True, "measure__frame_strain": 2.0**-8, "disks__count": 64}
SCENES = {
    "steady": {**SHORT, **TRAJECTORY},
    "measured": {**SHORT, **EVERYTHING},
    "papers": {**SHORT, "integration__scheme": "modified-velocity-verlet"},
    "replicas": {**SHORT, **TRAJECTORY, "disks__replicas": 3},
    "cascade": {**SHORT, "shear__protocol": "cascade", "shear__strain_rate": None,
                "shear__strain_rates": [2.0**-6, 2.0**-7]},
    "ramp": {**OFTEN, "shear__protocol": "ramp", "shear__strain_rate": 2.0**-10,
             "shear__strain_rate_high": 2.0**-9, "shear__ramp_rate": 0.01, "shear__discard": None,
             "shear__strain": 2.0**-6, "shear__ramp_window": 8.0, "output__sample_strain": None},
    "sequence": {**OFTEN, "shear__protocol": "sequence", "shear__strain_rate": None, "shear__strain": None,
                 "shear__pieces": [[2.0**-6, 2.0**-7], [-2.0**-6, 2.0**-7], [0, 64.0]],
                 "output__sample_strain": 2.0**-9},
    "oscillate": {**OFTEN, "shear__protocol": "oscillate", "shear__strain_rate": None, "shear__strain": None,
                  "shear__amplitude": 2.0**-7, "shear__period": 64.0, "shear__cycle_pieces": 16, "shear__cycles": 3,
                  "output__sample_strain": None, "output__trajectory_time": 16.0},
    "errors": {**SHORT, "shear__strain": 2.0**-2, "shear__discard": "auto",
               "shear__target_error": {"B_p": 0.5}, "output__sample_strain": 2.0**-10},
}
SWEEP = ('\n[sweep]\ngrid = {"disks.seed" = [1, 2]}\nzip = {"shear.strain_rate" = [0.015625, 0.0078125]}\n'
         'chain = "shear.strain_rate"\n')
KINDS = (*SCENES, "sweep")


def text_of(kind):
    """The scene or sweep file of a kind; tables of a key are written inline."""
    scene = changed(**SCENES.get(kind, SHORT))
    errors = scene["shear"].pop("target_error", None)
    text = scene_text(scene)
    if errors:
        inline = ", ".join(f"{name} = {value}" for name, value in errors.items())
        text = text.replace("[shear]\n", f"[shear]\ntarget_error = {{ {inline} }}\n")
    return text + (SWEEP if kind == "sweep" else "")


def content_of(folder):
    """The files that a run leaves, without what its clock says."""
    content = {}
    for path in sorted(folder.rglob("*")):
        name = str(path.relative_to(folder))
        if not path.is_file() or path.name.startswith(("checkpoint", ".lock", "log.txt", ".bagnold")) \
                or path.name.endswith(".tmp"):
            continue
        content[name] = path.read_bytes()
        if path.name == "summary.json":
            content[name] = json.loads(content[name])
            for clock in ("wall_seconds", "disk_steps_per_second"):
                content[name].pop(clock, None)
    return content


class Target:
    """A run of one kind, begun again and again in one folder."""

    def __init__(self, kind, folder):
        self.kind, self.folder = kind, folder
        folder.mkdir(parents=True, exist_ok=True)
        self.file, self.out = folder / f"{kind}.toml", folder / "out"
        self.file.write_text(text_of(kind))
        result = self.run()
        if result.returncode != 0:
            raise RuntimeError(f"{kind}: the undisturbed run failed: {result.stderr}")
        self.expected = content_of(self.out)

    def words(self):
        if self.kind == "sweep":
            return ["sweep", self.file, "--out", self.out, "--jobs", "1", "--quiet"]
        return ["run", self.file, "--out", self.out, "--quiet"]

    def clear(self):
        if self.out.is_dir() and not self.out.is_symlink():
            shutil.rmtree(self.out)
        else:
            self.out.unlink(missing_ok=True)

    def start(self, words=None, **options):
        """The process of a run, or of other words."""
        more = options.pop("env", {})
        options = {"stdin": subprocess.DEVNULL, "stdout": subprocess.DEVNULL,
                   "stderr": subprocess.PIPE, **options}
        command = [PROGRAM, *map(str, self.words() if words is None else words)]
        return subprocess.Popen(command, env=environment(**more), cwd=self.folder, **options)

    def run(self, words=None, timeout=120, **options):
        """A run from the beginning, or other words where the folder is; to its end."""
        if words is None:
            self.clear()
        process = self.start(words, **options)
        try:
            _, errors = process.communicate(timeout=timeout)
        except subprocess.TimeoutExpired:
            process.kill()
            process.communicate()
            return subprocess.CompletedProcess([], "hangs", "", "")
        return subprocess.CompletedProcess(process.args, process.returncode, "",
                                           (errors or b"").decode(errors="replace"))

    def go_on(self):
        """What a user would do after a failure: resume, or run where nothing was begun."""
        if self.kind == "sweep":
            return self.run(self.words())
        result = self.run(["resume", self.out, "--quiet"])
        if result.returncode == 2 and ("holds no run" in result.stderr or "no such folder" in result.stderr):
            result = self.run(self.words())
        return result

    def wrong_end(self, result, codes=(2, 4)):
        """What is wrong with how a disturbed run ended; "" if it may be so."""
        if result.returncode == "hangs" or result.returncode in (5, 127) or (
                isinstance(result.returncode, int) and result.returncode < 0):
            return f"ended with {result.returncode}: {result.stderr}"
        for word in ("terminate called", "what():", "Traceback", "Sanitizer", "HDF5-DIAG"):
            if word in result.stderr:
                return result.stderr
        allowed = (0, 1, *codes) if self.kind == "sweep" else (0, *codes)
        if result.returncode not in allowed:
            return f"exit code {result.returncode}: {result.stderr}"
        if result.returncode != 0 and not result.stderr.strip():
            return f"exit code {result.returncode} without a word"
        return ""

    def wrong_content(self):
        """What is wrong with the files of a run that says it is done."""
        found = content_of(self.out)
        if found.keys() != self.expected.keys():
            return f"other files: {sorted(found.keys() ^ self.expected.keys())}"
        other = [name for name in found if found[name] != self.expected[name]]
        return f"another content: {', '.join(other)}" if other else ""

    def wrong_after(self, result, killed=False):
        """The promise: done with the right files, or a word, and the right files when it goes on."""
        if not killed and (wrong := self.wrong_end(result)):
            return wrong
        if killed or result.returncode != 0:
            again = self.go_on()
            if again.returncode != 0:
                return f"{result.stderr}\nand goes on with {again.returncode}: {again.stderr}"
        return self.wrong_content()


class Targets:
    """Targets of all kinds, each made when it is wanted first."""

    def __init__(self, folder, kinds=KINDS):
        self.folder, self.kinds, self.made = folder, kinds, {}

    def any(self, random):
        kind = random.choice(self.kinds)
        if kind not in self.made:
            self.made[kind] = Target(kind, self.folder / kind)
        return self.made[kind]


def memory():
    """A folder in which files cost little."""
    return "/dev/shm" if os.path.isdir("/dev/shm") else None
