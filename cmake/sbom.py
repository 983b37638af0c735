#!/usr/bin/env python3
"""Prints a release's SBOM, in SPDX 2.3 as JSON. tests/release calls it.

cmake/sbom.py ARCHIVE VERSION COMMIT SECONDS [--RELATION PACKAGE...]...

ARCHIVE is the source archive of COMMIT, which was made SECONDS after 1970. RELATION is a word of
SPDX for what a Debian package is to the project. The shared libraries that the program links are
found by the compiler. One archive and the same installed packages give the same bytes.
"""

import argparse
import datetime
import hashlib
import json
import os
import pathlib
import platform
import re
import subprocess
import sys
import urllib.parse
import uuid

ROOT = pathlib.Path(__file__).resolve().parent.parent
MAINTAINERS = "Organization: The mixcmp maintainers"
PROJECT = "SPDXRef-mixcmp"
RELATIONS = ("BUILD_TOOL_OF", "BUILD_DEPENDENCY_OF", "TEST_DEPENDENCY_OF", "OPTIONAL_DEPENDENCY_OF")

# The shared libraries that the program names. tests/released compares them with a built program.
LINKED = ("libc.so.6", "libgcc_s.so.1", "libstdc++.so.6", "libCbcSolver.so", "libfmt.so",
          "libgmp.so", "libhwy.so", "libmpfi.so", "libmpfr.so", "libsqlite3.so",
          "libtomlplusplus.so")

# SPDX identifiers of licences, by the names that Debian gives them, in lower case.
LICENCES = {name.lower(): name for name in (
    "Apache-2.0", "Artistic-2.0", "BSD-2-Clause", "BSD-3-Clause", "BSL-1.0", "CC0-1.0", "EPL-1.0",
    "ISC", "MIT", "Zlib")} | {"expat": "MIT", "epl-1": "EPL-1.0"}


def output(*command):
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def owners(files):
    """The names of the Debian packages that hold the files."""
    # Debian 12 lists files of /usr/lib below /lib, where they were before the two became one.
    listed = {place: file for file in files for path in [os.path.realpath(file)]
              for place in (path, path.removeprefix("/usr"))}
    found = subprocess.run(["dpkg-query", "--search", *listed], capture_output=True, text=True)
    lines = [line.rsplit(": ", 1) for line in found.stdout.splitlines()]
    unknown = set(files) - {listed[place] for _, place in lines}
    if unknown:
        sys.exit(f"tests/release: no Debian package holds {' '.join(sorted(unknown))}")
    return {packages.split(":")[0] for packages, _ in lines}


def compiler_files():
    """The compiler itself, and each shared library as it finds it."""
    # c++ is a link to the compiler that the package g++ depends on.
    compiler = output("sh", "-c", "command -v c++").strip()
    return compiler, [output(compiler, f"-print-file-name={file}").strip() for file in LINKED]


def installed_packages():
    """Name -> version, architecture and source of each package of this machine's architecture."""
    fields = ("Package", "Version", "Architecture", "source:Package", "source:Version")
    lines = output("dpkg-query", "--show", "--showformat",
                   "${db:Status-Status}\t" + "\t".join(f"${{{f}}}" for f in fields) + "\n")
    architecture = output("dpkg", "--print-architecture").strip()
    rows = (line.split("\t")[1:] for line in lines.splitlines() if line.startswith("installed\t"))
    return {row[0]: row[1:] for row in rows if row[2] in (architecture, "all")}


def licences_of_files(copyright_file):
    """(files, licence) of each paragraph of a copyright file in Debian's machine-readable form."""
    try:
        text = copyright_file.read_text(encoding="utf-8", errors="replace")
    except FileNotFoundError:
        return []
    paragraphs = [dict(re.findall(r"^(Files|License):[ \t]*(\S.*?)[ \t]*$", paragraph, re.M))
                  for paragraph in re.split(r"\n[ \t]*\n", text)]
    return [(p["Files"], p["License"]) for p in paragraphs if len(p) == 2]


def spdx_licence(debian_name):
    """A licence as an SPDX expression; NOASSERTION where LICENCES has no name for a part of it."""
    parts = re.split(r" (and|or) ", debian_name)
    for i in range(0, len(parts), 2):
        gnu = re.fullmatch(r"(A?GPL|LGPL)-(\d)(?:\.(\d))?(\+?)", parts[i])
        if gnu:
            name, major, minor, later = gnu.groups()
            parts[i] = f"{name}-{major}.{minor or 0}-" + ("or-later" if later else "only")
        elif parts[i].lower() in LICENCES:
            parts[i] = LICENCES[parts[i].lower()]
        else:
            return "NOASSERTION"
    # Debian and SPDX agree that "and" binds more tightly than "or".
    return " ".join(part.upper() if part in ("and", "or") else part for part in parts)


def spdx_id(package):
    return "SPDXRef-deb-" + re.sub(r"[^A-Za-z0-9.-]", "-", package)


def debian_package(name, installed):
    version, architecture, source, source_version = installed
    system = platform.freedesktop_os_release()
    place = urllib.parse.quote(f"{name}@{version}", safe="@:~")
    described = {
        "SPDXID": spdx_id(name),
        "name": name,
        "versionInfo": version,
        "supplier": "Organization: Debian",
        "downloadLocation": "NOASSERTION",
        "filesAnalyzed": False,
        "sourceInfo": f"Debian source package {source} {source_version}",
        "licenseConcluded": "NOASSERTION",
        "licenseDeclared": "NOASSERTION",
        "copyrightText": "NOASSERTION",
        "externalRefs": [{
            "referenceCategory": "PACKAGE-MANAGER",
            "referenceType": "purl",
            "referenceLocator": f"pkg:deb/{system['ID']}/{place}?arch={architecture}"
                                f"&distro={system['ID']}-{system.get('VERSION_ID', 'sid')}"}]}
    for files, licence in licences_of_files(pathlib.Path("/usr/share/doc", name, "copyright")):
        if files == "*":
            described["licenseDeclared"] = spdx_licence(licence)
            described["licenseComments"] = f"Debian's copyright file says of most files: {licence}"
            break
    return described


def project(arguments):
    archive = arguments.archive
    licences = {licence for _, licence in licences_of_files(ROOT / ".reuse" / "dep5")}
    return {
        "SPDXID": PROJECT,
        "name": "mixcmp",
        "versionInfo": arguments.version,
        "packageFileName": archive.name,
        "supplier": MAINTAINERS,
        "downloadLocation": "NOASSERTION",
        "filesAnalyzed": False,
        "checksums": [{"algorithm": "SHA256",
                       "checksumValue": hashlib.sha256(archive.read_bytes()).hexdigest()}],
        "sourceInfo": f"git commit {arguments.commit}",
        "licenseConcluded": "NOASSERTION",
        "licenseDeclared": " AND ".join(sorted(licences)),
        "copyrightText": "NOASSERTION",
        "primaryPackagePurpose": "SOURCE",
        "externalRefs": [
            {"referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl",
             "referenceLocator": f"pkg:generic/mixcmp@{arguments.version}"},
            {"referenceCategory": "PERSISTENT-ID", "referenceType": "swh",
             "referenceLocator": f"swh:1:rev:{arguments.commit}"}]}


def extracted_licences():
    """The texts of licences that SPDX has no identifier for."""
    return [{"licenseId": text.stem, "extractedText": text.read_text(encoding="utf-8")}
            for text in sorted((ROOT / "LICENSES").glob("LicenseRef-*.txt"))]


def relations_of(arguments, installed):
    """Pairs of package and relation, sorted, without optional packages that are not installed."""
    pairs = {(name, relation) for relation in RELATIONS
             for name in getattr(arguments, relation)
             if name in installed or relation != "OPTIONAL_DEPENDENCY_OF"}
    missing = sorted(name for name, _ in pairs if name not in installed)
    if missing:
        sys.exit(f"tests/release: not installed: {' '.join(missing)}")
    compiler, libraries = compiler_files()
    pairs |= {(name, "BUILD_TOOL_OF") for name in owners([compiler])}
    pairs |= {(name, "DYNAMIC_LINK") for name in owners(libraries)}
    return sorted(pairs)


def relationship(package, relation):
    """DYNAMIC_LINK leads from the project to the package, each ..._OF from the package back."""
    ends = (spdx_id(package), PROJECT) if relation.endswith("_OF") else (PROJECT, spdx_id(package))
    return {"spdxElementId": ends[0], "relationshipType": relation, "relatedSpdxElement": ends[1]}


def document(arguments):
    installed = installed_packages()
    relations = relations_of(arguments, installed)
    created = datetime.datetime.fromtimestamp(arguments.seconds, datetime.timezone.utc)
    spdx = {
        "spdxVersion": "SPDX-2.3",
        "dataLicense": "CC0-1.0",
        "SPDXID": "SPDXRef-DOCUMENT",
        "name": f"mixcmp-{arguments.version}",
        "creationInfo": {"created": created.strftime("%Y-%m-%dT%H:%M:%SZ"),
                         "creators": [MAINTAINERS, "Tool: mixcmp tests/release"]},
        "packages": [project(arguments)] + [debian_package(name, installed[name])
                                            for name in sorted({name for name, _ in relations})],
        "hasExtractedLicensingInfos": extracted_licences(),
        "relationships": [{"spdxElementId": "SPDXRef-DOCUMENT", "relationshipType": "DESCRIBES",
                           "relatedSpdxElement": PROJECT}] +
                         [relationship(*pair) for pair in relations]}
    # A name for these contents alone, as SPDX demands it, without a random number in it.
    spdx["documentNamespace"] = uuid.uuid5(uuid.NAMESPACE_URL, json.dumps(spdx)).urn
    return spdx


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("archive", type=pathlib.Path)
    parser.add_argument("version")
    parser.add_argument("commit")
    parser.add_argument("seconds", type=int)
    for relation in RELATIONS:
        parser.add_argument(f"--{relation}", nargs="+", default=[])
    print(json.dumps(document(parser.parse_args()), indent=2))


main()
