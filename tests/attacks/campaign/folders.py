# SPDX-License-Identifier: BSD-3-Clause
"""Output folders as nobody should leave them: links that lead out, folders and pipes where files belong,
names that are code elsewhere. What lies outside must not change, and nobody may wait for ever."""

import os
import shutil

from target import Target

FILES = ("checkpoint.h5", "checkpoint.h5.tmp", "checkpoint.previous.h5", "state.h5", "state.h5.tmp",
         "result.h5", "summary.json", "summary.json.tmp", "scene.toml", "trajectory.h5md",
         "trajectory.h5md.tmp", "trajectory.parts", "trajectory.vtkhdf", "failed_state.h5", "plot.png")
NAMES = ("a b", "quo'te", 'dou"ble', "$(touch pwned)", "new\nline", "-rf", "x" * 255, "x" * 300, "ü=φ",
         "..", ".", "a/../b", "\x1b[31m", "%n%s", "{}", "a=1", "back\\slash", "*")


class Attack:
    def __init__(self, folder, random):
        self.folder, self.random = folder, random
        self.target = Target("steady", folder)
        self.usual_out = self.target.out
        self.outside = folder / "outside"

    def trial(self):
        shutil.rmtree(self.outside, ignore_errors=True)
        self.outside.mkdir()
        (self.outside / "file").write_text("mine")
        self.target.out = self.usual_out
        self.target.clear()
        what = self.random.choice((self.name, self.planted, self.planted, self.planted, self.parent))()
        words = self.target.words() + (["--force"] if self.random.random() < 0.6 else [])
        result = self.target.run(words, timeout=60)
        wrong = self.target.wrong_end(result)
        if sorted(os.listdir(self.outside)) != ["file"] or (self.outside / "file").read_bytes() != b"mine":
            wrong = wrong or "changed what lies outside"
        if (self.folder / "pwned").exists():
            wrong = wrong or "a name was executed"
        if result.returncode == 0 and not wrong:
            wrong = self.wrong_files()
        return what, wrong

    def wrong_files(self):
        """Of a run that says it is done; what was planted under other names may still be there."""
        for name, content in self.target.expected.items():
            file = self.target.out / name
            if name == "summary.json":
                continue  # its clock
            if file.is_symlink() or not file.is_file() or file.read_bytes() != content:
                return f"{name} is not what was computed"
        return ""

    def name(self):
        name = self.random.choice(NAMES)
        self.target.out = self.folder / "named" / name
        shutil.rmtree(self.folder / "named", ignore_errors=True)
        return f"out is named {name!r}"

    def parent(self):
        """The folder itself is no folder."""
        out, kind = self.target.out, self.random.choice(("a file", "a link in a circle", "a dangling link", "a pipe"))
        if kind == "a file":
            out.write_text("here")
        elif kind == "a pipe":
            os.mkfifo(out)
        else:
            out.symlink_to(out if kind == "a link in a circle" else self.folder / "nowhere")
        what = f"out is {kind}"
        return what

    def planted(self):
        self.target.out.mkdir(parents=True)
        told = []
        for name in self.random.sample(FILES, self.random.randint(1, 3)):
            file = self.target.out / name
            kind = self.random.choice(("link to a file", "link to a folder", "dangling link", "folder", "pipe",
                                       "empty", "garbage", "/dev/full", "/dev/zero"))
            told.append(f"{name}: {kind}")
            if kind == "link to a file":
                file.symlink_to(self.outside / "file")
            elif kind == "link to a folder":
                file.symlink_to(self.outside)
            elif kind == "dangling link":
                file.symlink_to(self.outside / "new")
            elif kind == "folder":
                (file / "within").mkdir(parents=True)
            elif kind == "pipe":
                os.mkfifo(file)
            elif kind.startswith("/dev"):
                file.symlink_to(kind)
            else:
                file.write_bytes(b"" if kind == "empty" else self.random.randbytes(3000))
        return ", ".join(told)

    def close(self):
        shutil.rmtree(self.folder, ignore_errors=True)
