#!/usr/bin/env python3
"""Whether the book and the READMEs agree with the tree.

Links lead somewhere; paths between backticks exist; a test named as `name` in `path` is there; a code block after
"From `path`:" stands in that file, white space aside. Run from anywhere: python3 docs/check.py
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
TOP = {".ci", "audit", "backends", "docs", "fuzz", "kernels-gen", "reference", "spec", "src", "tests"}
# Left behind by builds.
SKIPPED = {"target", "book", "corpus", "artifacts"}


def pages():
    yield from sorted(ROOT.glob("*.md"))
    for folder in sorted(TOP):
        for path in sorted((ROOT / folder).rglob("*.md")):
            if not SKIPPED & set(path.relative_to(ROOT).parts):
                yield path


def squeezed(text):
    return re.sub(r"\s+", "", text)


def faults_of(page):
    text = page.read_text(encoding="utf-8")
    prose = re.sub(r"^( *)```.*?^\1```$", "", text, flags=re.S | re.M)
    for target in re.findall(r"\]\(([^)\s]+)\)", prose):
        place = target.split("#")[0]
        if place and "://" not in place and not (page.parent / place).exists():
            yield f"link to {target}"
    for quoted in re.findall(r"`([A-Za-z.][\w./-]*/[\w./-]*)`", prose):
        if quoted.split("/")[0] in TOP and not (ROOT / quoted).exists() and not (page.parent / quoted).exists():
            yield f"path {quoted}"
    for name, place in re.findall(r"`(\w+)`\s+in\s+`([\w./-]+\.rs)`", prose):
        file = ROOT / place
        if file.exists() and not re.search(rf"\b(fn|struct|enum|trait|const) {name}\b", file.read_text(encoding="utf-8")):
            yield f"{name} in {place}"
    for place, block in re.findall(r"From `([^`]+)`:?\n\n```\w*\n(.*?)```", text, flags=re.S):
        file = ROOT / place
        if not file.exists() or squeezed(block) not in squeezed(file.read_text(encoding="utf-8")):
            yield f"excerpt of {place}: {block.strip().splitlines()[0]}"


def main():
    checked = 0
    faults = []
    for page in pages():
        checked += 1
        faults += [f"{page.relative_to(ROOT)}: {fault}" for fault in faults_of(page)]
    print("\n".join(f"not found: {fault}" for fault in faults) or f"{checked} pages agree with the tree")
    return 1 if faults or not checked else 0


if __name__ == "__main__":
    sys.exit(main())
