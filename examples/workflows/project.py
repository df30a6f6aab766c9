# SPDX-License-Identifier: BSD-3-Clause
"""python3 project.py: a job of signac for each elasticity. What is finished is loaded, what was stopped goes on."""

import bagnold
import signac

project = signac.init_project()
for elasticity in (1.0, 10.0):
    job = project.open_job({"elasticity": elasticity}).init()
    r = bagnold.run("scene.toml", out=job.fn("run"), disks__elasticity=job.sp.elasticity, threads=1, progress=False)
    job.document["p"] = float(r["p"].mean)
