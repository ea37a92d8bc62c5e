# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Desktops know files of Gatun by name and by content, with an icon, and open them with ParaView."""

import os
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

folder = sys.argv[1]  # Packaging
data = os.environ["GATUN_TEST_DATA"]
for tool in ("update-mime-database", "gio", "desktop-file-validate", "update-desktop-database"):
    if not shutil.which(tool):
        print("skipped: there is no", tool)
        sys.exit(125)

home = os.path.join(os.environ["GATUN_TEST_TEMP"], "desktop")
shutil.rmtree(home, ignore_errors=True)
share = os.path.join(home, "share")
applications = os.path.join(share, "applications")
os.makedirs(os.path.join(share, "mime", "packages"))
os.makedirs(applications)
shutil.copy(os.path.join(folder, "gatun.xml"), os.path.join(share, "mime", "packages"))
desktop = os.path.join(folder, "gatun-paraview.desktop")
shutil.copy(desktop, applications)
# The program need not be there to be found.
with open(os.path.join(applications, "gatun-paraview.desktop"), encoding="utf-8") as file:
    text = file.read().replace("paraview %f", "true %f").replace("TryExec=paraview", "TryExec=true")
with open(os.path.join(applications, "gatun-paraview.desktop"), "w", encoding="utf-8") as file:
    file.write(text)
environment = {**os.environ, "HOME": home, "XDG_DATA_HOME": share, "LC_ALL": "C.UTF-8"}


def run(*command):
    result = subprocess.run(
        command,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        universal_newlines=True,
        env=environment,
        check=False,
        timeout=60,
    )
    print(*command, result.stdout)
    assert result.returncode == 0, result.stdout
    return result.stdout


assert run("desktop-file-validate", desktop) == ""
run("update-mime-database", os.path.join(share, "mime"))
run("update-desktop-database", applications)
kinds = {
    "mesh": os.path.join(data, "Golden", "any_tets.gtn"),
    "volume": os.path.join(data, "Golden", "small_volume.ghv"),
}
for kind, golden in kinds.items():
    mime = f"application/x-gatun-{kind}"
    by_content = os.path.join(home, kind)
    shutil.copy(golden, by_content)
    by_name = os.path.join(home, "other" + os.path.splitext(golden)[1])
    with open(by_name, "wb") as file:
        file.write(b"\0\1")
    for file in (by_content, by_name, golden):
        said = run("gio", "info", "-a", "standard::content-type,standard::icon", file)
        assert f"content-type: {mime}\n" in said, said
        assert f"application-x-gatun-{kind}" in said, said
    assert "gatun-paraview.desktop" in run("gio", "mime", mime)
    icon = os.path.join(folder, "icons", f"application-x-gatun-{kind}.svg")
    assert ElementTree.parse(icon).getroot().tag == "{http://www.w3.org/2000/svg}svg"
# Damaged: the line end of the signature is changed, as a transfer as text does it.
with open(kinds["mesh"], "rb") as file:
    content = file.read().replace(b"\r\n", b"\n")
with open(os.path.join(home, "damaged"), "wb") as file:
    file.write(content)
assert "x-gatun" not in run("gio", "info", "-a", "standard::content-type", os.path.join(home, "damaged"))
