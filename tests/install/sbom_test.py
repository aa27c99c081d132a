#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
"""The list of what the packages are made of: what SPDX 2.3 asks for that its schema does not say.

    sbom_test.py surefoot.spdx.json [spdx-schema.json]

With SPDX's own schema (github.com/spdx/spdx-spec, schemas/spdx-schema.json) also by that: Debian,
python3-jsonschema.
"""
import json
import pathlib
import re
import sys


def problems(document):
    ids = [document["SPDXID"], *(package["SPDXID"] for package in document["packages"])]
    for name in ids:
        if not re.fullmatch(r"SPDXRef-[A-Za-z0-9.-]+", name):
            yield f"{name}: letters, numbers, . and - alone"
    if len(set(ids)) != len(ids):
        yield "two packages of one name"
    related = {document["SPDXID"]}
    for relation in document["relationships"]:
        for end in (relation["spdxElementId"], relation["relatedSpdxElement"]):
            related.add(end)
            if end not in ids:
                yield f"{end}: is related, but not there"
    for name in set(ids) - related:
        yield f"{name}: is related to nothing"
    if not re.fullmatch(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ", document["creationInfo"]["created"]):
        yield "created: a time in UTC is expected"
    for package in document["packages"]:
        if not re.fullmatch(r"[\w.+-]+( (AND|OR|WITH) [\w.+-]+)*", package["licenseDeclared"]):
            yield f"{package['name']}: licence '{package['licenseDeclared']}'"
        if not package.get("versionInfo"):
            yield f"{package['name']}: no version"
        for reference in package.get("externalRefs", []):
            if not re.fullmatch(r"pkg:(deb/debian|npm)/[^@ ]+@[^@ +:]+",
                                reference["referenceLocator"]):
                yield f"{package['name']}: purl '{reference['referenceLocator']}'"


def main():
    document = json.loads(pathlib.Path(sys.argv[1]).read_text())
    found = list(problems(document))
    if len(sys.argv) > 2:
        import jsonschema
        schema = json.loads(pathlib.Path(sys.argv[2]).read_text())
        validator = jsonschema.validators.validator_for(schema)(schema)
        found += [error.message for error in validator.iter_errors(document)]
    print(*found, f"{len(document['packages'])} packages", sep="\n")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
