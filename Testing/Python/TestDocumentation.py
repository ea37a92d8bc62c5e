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


def check_version():
    """Specifications and packages have the versions of gatunVersion.h, and all promise the same."""
    header = (ROOT / "Module" / "Support" / "gatunVersion.h").read_text(encoding="utf-8")
    for name, macro in (("format.md", "GATUN_FORMAT_VERSION"),
                        ("ghv-format.md", "GATUN_VOLUME_FORMAT_VERSION")):
        version = re.search(rf"#define {macro} (\d+)", header)[1]
        file = ROOT / "Documentation" / name
        found = re.search(r"^Format version (\d+)\b", file.read_text(encoding="utf-8"), flags=re.MULTILINE)
        if not found or found[1] != version:
            report(file, f"the version is not {version}, that of gatunVersion.h")
    version = ".".join(re.findall(r"#define GATUN_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)", header))
    file = ROOT / "debian" / "changelog"
    if not file.read_text(encoding="utf-8").startswith(f"gatun ({version})"):
        report(file, f"the version is not {version}, that of gatunVersion.h")
    for name in ("README.md", "CONTRIBUTING.md", "Documentation/format.md"):
        if PROMISE not in " ".join((ROOT / name).read_text(encoding="utf-8").split()):
            report(ROOT / name, f'does not promise: "{PROMISE}"')


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
