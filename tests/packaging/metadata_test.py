# SPDX-License-Identifier: BSD-3-Clause
"""What others' programs read of the repository: the citation, the workflow, issue templates, the list of changes.

BAGNOLD_SOURCE is the root of the repository.
"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import unittest

import yaml

SOURCE = pathlib.Path(os.environ.get("BAGNOLD_SOURCE", pathlib.Path(__file__).resolve().parents[2]))
VERSION = re.search(r"project\(Bagnold VERSION (\S+)", (SOURCE / "CMakeLists.txt").read_text())[1]


def read(path):
    return yaml.safe_load((SOURCE / path).read_text())


class Metadata(unittest.TestCase):
    def test_the_citation_has_what_its_format_requires(self):
        """Citation File Format 1.2.0: required keys, and those that hold for the program."""
        citation = read("CITATION.cff")
        self.assertEqual(citation["cff-version"], "1.2.0")
        for key in ("message", "title"):
            self.assertTrue(citation[key].strip(), key)
        self.assertTrue(all("name" in author or "family-names" in author for author in citation["authors"]))
        self.assertEqual(citation["version"], VERSION)
        self.assertIn(citation["license"], (SOURCE / "LICENSE").read_text().replace(" ", "-"))

    def test_what_archives_read_says_the_same(self):
        """codemeta.json and .zenodo.json beside CITATION.cff."""
        citation = read("CITATION.cff")
        abstract = citation["abstract"].strip()
        dois = {paper["doi"] for paper in citation["references"]}
        meta, zenodo = (json.loads((SOURCE / name).read_text()) for name in ("codemeta.json", ".zenodo.json"))
        for one, title in ((meta, "name"), (zenodo, "title")):
            self.assertEqual((one[title], one["version"], one["description"], one["keywords"]),
                             (citation["title"], VERSION, abstract, citation["keywords"]))
        names = [author["name"] for author in citation["authors"]]
        self.assertEqual([author["name"] for author in meta["author"]], names)
        self.assertEqual([author["name"] for author in zenodo["creators"]], names)
        self.assertTrue(meta["license"].endswith("/" + citation["license"]))
        self.assertEqual(zenodo["license"]["id"], citation["license"])
        self.assertEqual({paper["@id"].removeprefix("https://doi.org/") for paper in meta["referencePublication"]}, dois)
        self.assertEqual({one["identifier"] for one in zenodo["related_identifiers"]}, dois)

    @unittest.skipUnless(shutil.which("cffconvert"), "needs cffconvert (PyPI)")
    def test_the_citation_is_valid(self):
        subprocess.run(["cffconvert", "--validate", "-i", SOURCE / "CITATION.cff"], check=True, capture_output=True)

    def test_the_papers_of_the_citation_are_those_of_the_readme(self):
        papers = read("CITATION.cff")["references"]
        readme = (SOURCE / "README.md").read_text()
        self.assertEqual(len(papers), 2)
        for paper in papers:
            self.assertIn(paper["title"].strip(), readme)
            self.assertIn(f"**{paper['volume']}**, {paper['start']} ({paper['year']})", readme)
            self.assertEqual(paper["doi"], f"10.1103/PhysRevE.{paper['volume']}.{paper['start']}")

    def test_the_changes_end_with_this_version(self):
        newest = re.search(r"^## (\d[\w.]*) \((.*)\)$", (SOURCE / "CHANGELOG.md").read_text(), re.M)
        self.assertEqual(newest.groups(), (VERSION, read("CITATION.cff")["date-released"]))

    def test_what_the_release_was_checked_by(self):
        about = json.loads((SOURCE / "docs/data/releases" / VERSION / "release.json").read_text())
        self.assertEqual(about["version"], VERSION)

    def test_the_workflow_calls_the_check_of_the_repository(self):
        workflow = read(".github/workflows/check.yml")
        job, = workflow["jobs"].values()
        self.assertEqual(job["container"], "debian:12")
        self.assertIn(".ci/run", [step.get("run") for step in job["steps"]])
        self.assertTrue(os.access(SOURCE / ".ci/run", os.X_OK))
        self.assertIn("pull_request", workflow[True])  # YAML 1.1 reads `on` so

    def test_issue_templates_are_forms(self):
        forms = [path for path in (SOURCE / ".github/ISSUE_TEMPLATE").glob("*.yml") if path.name != "config.yml"]
        self.assertGreaterEqual(len(forms), 3)
        for path in forms:
            form = read(path.relative_to(SOURCE))
            for key in ("name", "description", "body"):
                self.assertTrue(form[key], path.name)
            for part in form["body"]:
                self.assertTrue(part["attributes"]["label"], path.name)
            self.assertEqual(len({part["id"] for part in form["body"]}), len(form["body"]), path.name)


if __name__ == "__main__":
    unittest.main()
