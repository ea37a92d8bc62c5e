#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Shows what Gatun does; setup.sh demo calls it. GATUN_BUILD names the build to use.

set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${GATUN_BUILD:-$root/build/release}

"$build/bin/gtn" --version
