"""Checks a FuseSoC core file: its form, and that its files exist. Prints its targets.
check_core.py FOLDER
"""

import pathlib
import sys

import yaml

folder = pathlib.Path(sys.argv[1])
(path,) = folder.glob("*.core")
text = path.read_text(encoding="utf-8")
assert text.startswith("CAPI=2:\n"), "the first line is not CAPI=2:"
core = yaml.safe_load(text)
assert len(core["name"].split(":")) == 4, core["name"]
for name, fileset in core["filesets"].items():
    for entry in fileset["files"]:
        options = {} if isinstance(entry, str) else next(iter(entry.values()))
        file = entry if isinstance(entry, str) else next(iter(entry))
        assert (folder / file).is_file(), f"fileset {name}: there is no {file}"
        assert "file_type" in options or "file_type" in fileset, f"{file} has no type"
for name, target in core["targets"].items():
    assert target["toplevel"], f"target {name} has no toplevel"
    for fileset in target["filesets"]:
        assert fileset in core["filesets"], f"target {name}: there is no fileset {fileset}"
    if "default_tool" in target:
        assert target["default_tool"] in target["tools"], f"target {name} has no such tool"
print(" ".join(core["targets"]))
