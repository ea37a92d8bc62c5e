# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The documentation: pages and README's table follow from their results, other texts have no measured
numbers, links and images resolve, and the code, the specification and
the golden files agree on the newest version of the format."""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "Benchmarks" / "Studies"))

import generatedParts  # pylint: disable=wrong-import-position

# Not ours, or not sources.
SKIPPED = ("build", ".git")

# Measured numbers look like this. They belong on the pages of the studies.
MEASURED = [re.compile(pattern) for pattern in (
    r"\d (times|x) as (fast|long|large|much|many|slow|wrong|small)",
    r"\d times (faster|slower|smaller|larger|fewer|less|more|better|worse)",
    r"\d\*{0,2} bits (per|a) (tetrahedron|point|voxel)",
    r"\d (M|million) (tets|tetrahedra) (per|a) second",
    r"\d(\.\d+)? (ms|milliseconds)\b",
    r"\d % (of the|fewer|less|more|smaller|larger|faster|slower)")]

problems = []


def report(file, what):
    problems.append(f"{file.relative_to(ROOT)}: {what}")


def documents():
    for file in sorted(ROOT.rglob("*.md")):
        if not file.relative_to(ROOT).parts[0].startswith(SKIPPED):
            yield file


def without_code(text):
    text = re.sub(r"^```.*?^```", "", text, flags=re.MULTILINE | re.DOTALL)
    return re.sub(r"`[^`\n]*`", "code", text)


def anchor(heading):
    """The name of a heading as GitHub and GitLab make it."""
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading.replace("`", "")).strip().lower()
    return re.sub(r"[^\w\- ]", "", text).replace(" ", "-")


def anchors(file):
    text = re.sub(r"^```.*?^```", "", file.read_text(encoding="utf-8"),
                  flags=re.MULTILINE | re.DOTALL)
    return {anchor(heading) for heading in re.findall(r"^#+ (.*)$", text, flags=re.MULTILINE)}


def check_links(file):
    for target in re.findall(r"\]\(([^)\s]+)\)", without_code(file.read_text(encoding="utf-8"))):
        if re.match(r"[a-z]+:", target):
            continue
        path, _, name = target.partition("#")
        found = (file.parent / path).resolve() if path else file
        if not found.exists():
            report(file, f"{target} does not exist")
        elif name and found.suffix == ".md" and name not in anchors(found):
            report(file, f"{target}: there is no such heading")


def check_numbers(file):
    """Guides, README and changelog; README's table is written by a program."""
    text = file.read_text(encoding="utf-8")
    if generatedParts.BEGIN in text:
        before, rest = text.split(generatedParts.BEGIN, 1)
        text = before + rest.split(generatedParts.END, 1)[1]
    text = " ".join(without_code(text).split())
    for pattern in MEASURED:
        for found in pattern.finditer(text):
            around = text[max(0, found.start() - 40):found.end() + 20]
            report(file, f'a measured number outside of the studies: "...{around}..."')


def check_version():
    header = (ROOT / "Module" / "Support" / "gatunVersion.h").read_text(encoding="utf-8")
    newest = ".".join(re.search(rf"#define GATUN_FORMAT_VERSION_{part} (\d+)", header)[1]
                      for part in ("MAJOR", "MINOR"))
    for name, pattern in (("format.md", r"^Format version (\d+\.\d+)\."),
                          ("format-changelog.md", r"^## (\d+\.\d+)$")):
        file = ROOT / "Documentation" / name
        found = re.search(pattern, file.read_text(encoding="utf-8"), flags=re.MULTILINE)
        if not found or found[1] != newest:
            report(file, f"the newest version is not {newest}, that of gatunVersion.h")
    golden = ROOT / "Testing" / "Data" / "Golden"
    versions = [[int(part) for part in re.findall(r"\d+", folder.name)]
                for folder in golden.glob("v*.*")]
    if max(versions) != [int(part) for part in newest.split(".")]:
        report(golden, f"there is nothing of version {newest}")


def main():
    for file in generatedParts.find_differing():
        report(file, "differs from its results.json; Utilities/bench.sh --pages writes it again")
    guides = [ROOT / "README.md", ROOT / "CHANGELOG.md",
              *sorted((ROOT / "Documentation").glob("*.md"))]
    for file in guides:
        if file.name not in ("format.md", "ghv-format.md"):
            check_numbers(file)
    for file in documents():
        check_links(file)
    check_version()
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    if readme.count("\n") >= 100:
        report(ROOT / "README.md", "has 100 lines or more")
    for problem in problems:
        print(problem)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
