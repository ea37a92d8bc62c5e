# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The documentation: pages and README's table follow from their results, other texts have no measured
numbers, links and images resolve, the map of the core is complete, and the code, the specification and
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

PROMISE = ("From the release 0.1.0 on, every later reader of the same major version reads a file; until then none "
           "is promised")

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


def check_map():
    """Every unit of the core is in the map of design.md, and nothing else is."""
    file = ROOT / "Documentation" / "design.md"
    listed = set(re.findall(r"`(gatun\w+)`", file.read_text(encoding="utf-8").split(
        "## Map of the core", 1)[1]))
    units = {source.stem for source in (ROOT / "Module").glob("*/gatun*.*")}
    for unit in sorted(units - listed):
        report(file, f"{unit} is missing in the map of the core")
    for unit in sorted(listed - units):
        report(file, f"{unit} is in the map of the core, but not in Module")


def check_version():
    """The specifications have the versions of gatunVersion.h, and all promise the same."""
    header = (ROOT / "Module" / "Support" / "gatunVersion.h").read_text(encoding="utf-8")
    for name, macro in (("format.md", "GATUN_FORMAT_VERSION"),
                        ("ghv-format.md", "GATUN_VOLUME_FORMAT_VERSION")):
        version = re.search(rf"#define {macro} (\d+)", header)[1]
        file = ROOT / "Documentation" / name
        found = re.search(r"^Format version (\d+)\b", file.read_text(encoding="utf-8"), flags=re.MULTILINE)
        if not found or found[1] != version:
            report(file, f"the version is not {version}, that of gatunVersion.h")
    for name in ("README.md", "CONTRIBUTING.md", "Documentation/format.md"):
        if PROMISE not in " ".join((ROOT / name).read_text(encoding="utf-8").split()):
            report(ROOT / name, f'does not promise: "{PROMISE}"')


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
    check_map()
    check_version()
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    if readme.count("\n") >= 100:
        report(ROOT / "README.md", "has 100 lines or more")
    for problem in problems:
        print(problem)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
