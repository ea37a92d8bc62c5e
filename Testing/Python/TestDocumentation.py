# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The documentation: pages of measurements and README's table follow from the results, links and images
resolve, and the code, the specification and the golden files agree on the version of the format."""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "Benchmarks"))

import report as benchmarks  # pylint: disable=wrong-import-position

# Not ours, or not sources.
SKIPPED = ("build", ".git")

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
    for file in benchmarks.find_differing():
        report(file, "differs from performance/results.json; Utilities/setup.sh bench --pages writes it")
    for file in documents():
        check_links(file)
    check_version()
    for problem in problems:
        print(problem)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
